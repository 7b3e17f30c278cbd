/* What tests of one C file each ask. */
#ifndef FOREDRAW_TESTS_CHECK_H
#define FOREDRAW_TESTS_CHECK_H

#include <stdio.h>

static int failures = 0;

#define CHECK(condition)                                     \
  do {                                                       \
    if (!(condition)) {                                      \
      printf("%s:%d: %s\n", __FILE__, __LINE__, #condition); \
      ++failures;                                            \
    }                                                        \
  } while (0)

#endif
