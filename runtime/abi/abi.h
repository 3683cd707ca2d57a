/* What a compiled model and the runtime agree on. Not for embedders: they include the emitted header alone.
   SPDX-License-Identifier: BSD-3-Clause */
#ifndef KANEC_ABI_H
#define KANEC_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define KANEC_ABI_VERSION 2u

/* One evaluation. Every emitted function has this shape; arguments that it does not read may be null.
   The results of a combined function stand one after another in out.
   prepared: what prepare() filled; t [s]; x (nx); y (ny); ydot (ny); u: inputs (n_inputs); out (n_out).
   No allocation, no global state, safe from several threads at once. */
typedef void (*kanec_evaluate)(const void* prepared, double t, const double* x, const double* y, const double* ydot,
                               const double* u, double* out);

typedef struct kanec_function {
  const char* name; /* "accelerations" */
  int32_t n_out;
  /* operations of one evaluation, exact */
  int32_t adds, multiplies, divides, square_roots, trigonometric, other_functions;
  kanec_evaluate evaluate;
} kanec_function;

/* Where a set of Euler parameters stands in x (the first of 4), and the angular velocity that moves it in y (of 3). */
typedef struct kanec_attitude {
  int32_t eps, omega;
} kanec_attitude;

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
} kanec_model;

/* The one symbol that a compiled model exports. */
typedef const kanec_model* (*kanec_entry)(void);
#define KANEC_ENTRY "kanec_model_entry"

#ifdef __cplusplus
}
#endif

#endif
