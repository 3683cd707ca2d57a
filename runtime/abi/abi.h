/* What a compiled model and its callers agree on: kanec's own runtime, and any program that calls C (docs/embed_c.md). Not
   needed with an emitted header.
   SPDX-License-Identifier: BSD-3-Clause */
#ifndef KANEC_ABI_H
#define KANEC_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Raised with every change of what stands below; abi_version and struct_size stay in front. */
#define KANEC_ABI_VERSION 5u

/* One evaluation. Every emitted function has this shape; arguments that it does not read may be null.
   The results of a combined function stand one after another in out.
   prepared: what prepare() filled; t [s]; x (nx); y (ny); ydot (ny); u: inputs (n_inputs); out (n_out).
   No allocation, no global state, safe from several threads at once. */
typedef void (*kanec_evaluate)(const void* prepared, double t, const double* x, const double* y, const double* ydot,
                               const double* u, double* out);

/* What a function reads, of which the rest may be null. */
#define KANEC_READS_T 1u
#define KANEC_READS_X 2u
#define KANEC_READS_Y 4u
#define KANEC_READS_YDOT 8u
#define KANEC_READS_U 16u

typedef struct kanec_function {
  const char* name; /* "accelerations" */
  int32_t n_out;
  /* operations of one evaluation, exact */
  int32_t adds, multiplies, divides, square_roots, trigonometric, other_functions;
  uint32_t reads; /* KANEC_READS_... */
  kanec_evaluate evaluate;
} kanec_function;

/* Where a set of Euler parameters stands in x (the first of 4), and the angular velocity that moves it in y (of 3). */
typedef struct kanec_attitude {
  int32_t eps, omega;
} kanec_attitude;

/* Taylor series of the motion in one kind of scalar. Scalars stand in its own arrays; nothing is allocated. */
typedef struct kanec_taylor {
  int32_t scalar_size;   /* sizeof(double), or of long double */
  int32_t size;          /* nx + ny, or one more: the work of the loads, where the model has their power */
  int32_t highest_order;
  size_t prepared_size, work_size, alignment; /* bytes, of prepared parameters and of work */
  void (*prepare)(const double* parameters, void* prepared);
  /* z[k * size + i]: coefficient k of entry i of (x, y, work) in the time since t, k = 0 ... order; k = 0 is given.
     1 <= order <= highest_order; work need not be initialised, and holds nothing between calls. */
  void (*coefficients)(const void* prepared, double t, const double* u, int32_t order, void* z, void* work);
} kanec_taylor;

/* Entries of a matrix that are not always 0, row by row; wherever a function of the model returns that matrix. */
typedef struct kanec_pattern {
  const char* name; /* "accelerations_x" */
  int32_t rows, columns, nonzeros;
  const int32_t *row_of, *column_of; /* (nonzeros) */
} kanec_pattern;

typedef struct kanec_model {
  uint32_t abi_version; /* KANEC_ABI_VERSION */
  uint32_t struct_size; /* sizeof(kanec_model) */
  const char* name;
  const char* hash; /* of scene, generator and options: 16 hexadecimal digits */
  int32_t n_bodies, nx, ny, n_parameters, n_inputs, n_functions;
  const char* const* parameter_names; /* (n_parameters): those of the scene that its functions read */
  const double* parameter_defaults;
  const char* const* input_names; /* (n_inputs), likewise */
  const double* input_defaults;
  size_t prepared_size; /* bytes of the prepared parameters, at least 1; alignment of double */
  void (*prepare)(const double* parameters, void* prepared);
  const kanec_function* functions; /* (n_functions) */
  const char* const* coordinate_names; /* (nx): "theta_3" */
  const char* const* speed_names;      /* (ny): "thetadot_3" */
  int32_t n_attitudes;
  const kanec_attitude* attitudes; /* (n_attitudes) */
  int32_t n_taylor;
  const kanec_taylor* taylor; /* (n_taylor): none unless the model was compiled with KANEC_TAYLOR */
  int32_t n_patterns;
  const kanec_pattern* patterns; /* (n_patterns) */
} kanec_model;

/* The one symbol that a compiled model exports. */
typedef const kanec_model* (*kanec_entry)(void);
#define KANEC_ENTRY "kanec_model_entry"

/* Many states at once, in double or in float (kanec_batch: scalar_size). They stand in blocks of `stride` states: of an
   argument with n entries, entry i of state j is a[(j / stride * n + i) * stride + j % stride]. Two cases of this:
   stride >= number of states: entry i of state j at a[i * stride + j], one array an entry;
   stride = lanes: what is computed at once stands together; faster, and copied not at all where aligned to its size.
   stride = 1: entry i of state j at a[j * n + i], state after state; gathered, a little slower.
   Any other stride below the number of states is a multiple of the lanes. */
typedef struct kanec_states {
  int64_t begin, end; /* states to evaluate: begin <= j < end; begin a multiple of the lanes */
  int64_t stride;
  const void* prepared; /* what prepare() filled: one group a `lanes` states, or one for all */
  const void* t;        /* (number of states), or one for all; whatever the stride */
  const void *x, *y, *ydot;
  const void* u;                                  /* as x, or (n_inputs) for all */
  int32_t one_parameters, one_time, one_inputs; /* not 0: for all states */
  void* scratch;                                /* scratch_size bytes; each thread its own */
} kanec_states;

/* kanec_evaluate for each of these states; out as x, states before begin and from end on not written. */
typedef void (*kanec_evaluate_batch)(const kanec_states* states, void* out);

/* One group of scenarios, as many as there are lanes, each from its own state with its own parameters and inputs. All
   arrays are of the batch's scalar, entry i of lane l at [i * lanes + l], aligned. */
typedef struct kanec_group {
  double begin, end;    /* time [s], in `steps` equal steps */
  int64_t steps;        /* at least 1 */
  const void* prepared; /* of this group */
  const void* u;        /* (n_inputs) */
  void* z;              /* (size): x, y, and the work of the loads where the rates have their power; replaced */
  void* norm_error;     /* (1): worst | |eps| - 1 | of a step's end before projection; raised */
  void* finite_until;   /* (1): end of the last step after which all of z was finite; replaced where one was */
} kanec_group;

/* The classical Runge-Kutta method on a group; Euler parameters are projected to unit norm after every step. */
typedef struct kanec_rk4 {
  int32_t size; /* nx + ny, or one more */
  void (*steps)(const kanec_group* group);
} kanec_rk4;

/* The same functions compiled for lanes: a library of its own. */
typedef struct kanec_batch {
  uint32_t abi_version;     /* KANEC_ABI_VERSION */
  uint32_t struct_size;     /* sizeof(kanec_batch) */
  const kanec_model* model; /* names, sizes, operations; its prepare and evaluate are null */
  int32_t lanes;            /* states that are computed at once */
  int32_t scalar_size;      /* sizeof(double) or sizeof(float) */
  size_t prepared_size;     /* bytes of a group of prepared parameters */
  size_t alignment;         /* of prepared parameters and scratch */
  size_t scratch_size; /* bytes, at least 1 */
  /* Parameters of states begin .. end - 1 as x stands; begin a multiple of the lanes. A last group that is not full, and
     so a single state, has its last state's in all further lanes. */
  void (*prepare)(int64_t begin, int64_t end, int64_t stride, const void* parameters, void* prepared);
  const kanec_evaluate_batch* evaluate; /* (model->n_functions), in their order */
  const kanec_rk4* rk4; /* null where the model was emitted without kinematics+accelerations(+power), in this order */
} kanec_batch;

typedef const kanec_batch* (*kanec_batch_entry)(void);
#define KANEC_BATCH_ENTRY "kanec_model_batch"

#ifdef __cplusplus
}
#endif

#endif
