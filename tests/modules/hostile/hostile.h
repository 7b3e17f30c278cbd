/* What modules that misbehave have in common. */
#ifndef HOSTILE_H
#define HOSTILE_H
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <foredraw/c/module.h>

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* static int run(RUN) { ... } */
#define RUN                                                                                      \
  void *user, const foredraw_draw *draw, const foredraw_value *options, foredraw_answer *answer, \
      const foredraw_host *host

/* The order that there is, in which nothing changes. */
static int as_it_is(RUN) {
  (void)user, (void)draw, (void)options, (void)host;
  for (uint64_t i = 0; i < answer->count; ++i) answer->values[i] = (uint32_t)i;
  return FOREDRAW_DONE;
}
#define AS_IT_IS as_it_is(user, draw, options, answer, host)
#define UNUSED (void)user, (void)draw, (void)options, (void)answer, (void)host

/* The module "hostile-NAME" of what `run` does. */
#define MODULE(name) MODULE_OF(name, FOREDRAW_TRIANGLE_ORDERER, NULL, 0)
#define MODULE_OF(name, kind, metrics, metric_count) MODULE_WITH(name, kind, metrics, metric_count, 0)
/* One that asks for overdraw. */
#define MODULE_THAT_ASKS(name) MODULE_WITH(name, FOREDRAW_TRIANGLE_ORDERER, NULL, 0, FOREDRAW_USES_OVERDRAW)
#define MODULE_WITH(name, kind, metrics, metric_count, flags)                                        \
  static const foredraw_plugin plugin = {sizeof(foredraw_plugin),                                    \
                                         kind,                                                       \
                                         "hostile-" name,                                            \
                                         "Misbehaves",                                               \
                                         "own",                                                      \
                                         NULL,                                                       \
                                         NULL,                                                       \
                                         NULL,                                                       \
                                         NULL,                                                       \
                                         metrics,                                                    \
                                         0,                                                          \
                                         metric_count,                                               \
                                         1,                                                          \
                                         NULL,                                                       \
                                         run,                                                        \
                                         NULL,                                                       \
                                         NULL,                                                       \
                                         flags};                                                     \
  static const foredraw_plugin* const plugins[] = {&plugin};                                         \
  static const foredraw_module module = {sizeof(foredraw_module), 1, 0, 1, "hostile", "0", plugins}; \
  FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) {                                  \
    (void)as_it_is;                                                                                  \
    return &module;                                                                                  \
  }

#endif
