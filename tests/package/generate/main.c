/* The emitted C header. SPDX-License-Identifier: BSD-3-Clause */
#include <stdio.h>

#include "swing.h"

int main(void) {
  const swing_Parameters parameters = swing_default_parameters();
  const swing_Prepared prepared = swing_prepare(&parameters);
  const swing_real x[swing_nx] = {0.5}, y[swing_ny] = {0};
  swing_real ydot[swing_ny];
  swing_accelerations(&prepared, x, y, ydot);
  printf("%.6f\n", (double)ydot[swing_at_thetadot_bob]);
  return 0;
}
