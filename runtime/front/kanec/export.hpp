// What of a declaration is seen outside of its library. Not: any declaration.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if defined(__GNUC__)
#define KANEC_API __attribute__((visibility("default")))
#else
#define KANEC_API
#endif
