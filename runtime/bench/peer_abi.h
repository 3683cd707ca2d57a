/* What kanec bench, kanec report and the adapters of other engines (tests/bench/peers) agree on: a model and its states
   in relative coordinates, in plain C. Not for embedders. SPDX-License-Identifier: BSD-3-Clause */
#ifndef KANEC_PEER_ABI_H
#define KANEC_PEER_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define KANEC_PEER_ABI_VERSION 2u

/* Body K, numbered from 1, whose joint moves it relative to L(K): first along its slides, then a ball or its turns in
   order. Matrices are row-major, SI units. */
typedef struct kanec_peer_body {
  int32_t lower; /* L(K) < K; 0: the inertial frame */
  int32_t n_slides, n_turns, is_ball;
  double mass;
  double inertia[9]; /* about the mass centre, body axes */
  double r[3];       /* mass centre from the body origin, body axes */
  double q[3];       /* joint point from the lower body's origin, lower body's axes */
  double slides[9];  /* a unit axis a row, lower body's axes */
  double turns[9];   /* a unit axis a row, lower body's axes as it stands when all angles are zero */
  double zero[9];    /* K's components to L(K)'s when all angles are zero; of a ball the identity */
} kanec_peer_body;

/* Body by body: q has the slides, then the angles or a ball's Euler parameters, which take components in K to
   components in L(K), scalar last; u the rates of slides and angles, of a ball the angular velocity relative to L(K),
   K's axes; force what does work on u. */
typedef struct kanec_peer_model {
  int32_t n_bodies, n_q, n_u;
  const kanec_peer_body* bodies; /* (n_bodies) */
  double gravity[3];             /* inertial axes */
} kanec_peer_model;

/* A way in which the engine integrates a motion: with equal steps, or with an accuracy that it takes as it understands
   it. */
typedef struct kanec_peer_integrator {
  const char* name; /* "RungeKuttaMerson" */
  int32_t has_fixed_step;
} kanec_peer_integrator;

/* One motion from the state of a slot at t = 0, under gravity alone. */
typedef struct kanec_peer_run {
  int32_t integrator, slot;
  double fineness; /* the longest step [s], or the accuracy */
  double limit;    /* of wall time, after which the run is given up [s] */
  int32_t n_times;
  const double* times; /* (n_times), rising, above 0 [s]; none of these states is interpolated */
} kanec_peer_run;

typedef struct kanec_peer_motion {
  double *q, *u;  /* (n_times * n_q), (n_times * n_u) */
  double seconds; /* wall time of the integration alone */
  int64_t steps, evaluations;
  int32_t is_late; /* given up at the limit */
} kanec_peer_motion;

typedef struct kanec_peer {
  uint32_t abi_version; /* KANEC_PEER_ABI_VERSION */
  uint32_t struct_size; /* sizeof(kanec_peer) */
  const char* name;     /* "MuJoCo 2.2.2" */
  const char* note;     /* what has to be known beside a time, or "" */
  /* A simulation with room for n_slots states; null, and the cause in message, where the engine cannot have it. */
  void* (*create)(const kanec_peer_model* model, int32_t n_slots, char* message, size_t message_size);
  void (*destroy)(void* simulation);
  /* Keeps a state in the engine's own coordinates; not timed. */
  void (*set)(void* simulation, int32_t slot, const double* q, const double* u, const double* force);
  /* What is timed: the shortest way from that state to accelerations. */
  void (*accelerate)(void* simulation, int32_t slot);
  /* The rates of u that the last accelerate() gave (n_u); not timed. */
  void (*result)(void* simulation, double* u_rate);
  /* How it integrates; none where there is nothing but accelerate(). */
  int32_t n_integrators;
  const kanec_peer_integrator* integrators;
  /* 0, or 1 and the cause in message; q and u are filled as far as the run came. */
  int32_t (*integrate)(void* simulation, const kanec_peer_run* run, kanec_peer_motion* motion, char* message,
                       size_t message_size);
} kanec_peer;

/* The one symbol that an adapter exports. */
typedef const kanec_peer* (*kanec_peer_entry_function)(void);
#define KANEC_PEER_ENTRY "kanec_peer_entry"

#ifdef __cplusplus
}
#endif

#endif
