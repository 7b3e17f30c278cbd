/* Tables that are wrong: which, says WRONG. */
#include "hostile.h"
enum {
  minor_9 = 1,
  small,
  small_plugin,
  many_plugins,
  null_plugins,
  null_plugin,
  no_vendor,
  odd_vendor,
  other_vendor,
  default_beyond,
  no_choices,
  null_option_name,
  no_kind,
  null_run,
  null_module,
  many_options,
  odd_flags,
  lossless_order,
  overdraw_vertices
};
static int run(RUN) { return AS_IT_IS; }
static const foredraw_option number = {"power", "", "", FOREDRAW_NUMBER, 0, NULL, {0, 9.0, NULL}, 0.0, 4.0};
static const foredraw_option choice = {"power", "", "", FOREDRAW_CHOICE, 0, NULL, {0, 0.0, "one"}, 0.0, 4.0};
static const foredraw_option nameless = {NULL, "", "", FOREDRAW_NUMBER, 0, NULL, {0, 1.0, NULL}, 0.0, 4.0};
static const foredraw_plugin plugin = {
    WRONG == small_plugin ? 8 : sizeof(foredraw_plugin),
    WRONG == no_kind             ? 77
    : WRONG == overdraw_vertices ? FOREDRAW_VERTEX_ORDERER
                                 : FOREDRAW_TRIANGLE_ORDERER,
    WRONG == other_vendor ? "tipsify" : "hostile-tables",
    "Misbehaves",
    "own",
    NULL,
    NULL,
    NULL,
    WRONG == default_beyond     ? &number
    : WRONG == no_choices       ? &choice
    : WRONG == null_option_name ? &nameless
                                : NULL,
    NULL,
    WRONG == many_options ? 1u << 31 : WRONG >= default_beyond && WRONG <= null_option_name,
    0,
    1,
    NULL,
    WRONG == null_run ? NULL : run,
    NULL,
    NULL,
    WRONG == odd_flags           ? 64
    : WRONG == lossless_order    ? FOREDRAW_LOSSLESS
    : WRONG == overdraw_vertices ? FOREDRAW_USES_OVERDRAW
                                 : 0};
static const foredraw_plugin* const plugins[] = {WRONG == null_plugin ? NULL : &plugin};
static const foredraw_module module = {WRONG == small ? 8 : sizeof(foredraw_module),
                                       1,
                                       WRONG == minor_9 ? 9 : 0,
                                       WRONG == many_plugins ? 1u << 31 : 1,
                                       WRONG == no_vendor    ? NULL
                                       : WRONG == odd_vendor ? "Hostile Inc."
                                                             : "hostile",
                                       "0",
                                       WRONG == null_plugins ? NULL : plugins};
FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) { return WRONG == null_module ? NULL : &module; }
