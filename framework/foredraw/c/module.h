/* A module: techniques in a shared library that Foredraw loads by --module, in a process of their own. C99; nothing to
 * link.
 *
 *   static const foredraw_plugin radial = {.size = sizeof radial, .kind = FOREDRAW_TRIANGLE_ORDERER, ...};
 *   static const foredraw_plugin* const plugins[] = {&radial};
 *   static const foredraw_module module = {sizeof module, 1, 0, 1, "acme", "1.0.0", plugins};
 *   FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) { return &module; }
 *
 *   cc -shared -fPIC -o acme.so acme.c
 *   foredraw compare house.glb --module acme.so -p "tipsify" -p "acme-radial"
 *
 * - The program never loads the module itself, unless it is told to (--modules inside): a worker does, which is told of
 *   calls. Each worker makes one call at a time. There may be several, and a technique has to answer the same in each,
 *   so it keeps nothing from one call to the next.
 * - A draw lies in memory that can not be written. All memory of a call is lent until it returns.
 * - What goes wrong costs the draw that the call was about, which stays as it was: a wrong answer, a crash, no answer
 *   within the limit (10 minutes) or within 2 seconds after `cancelled` says so. After three deaths of its workers a
 *   module is left out.
 * - Texts are UTF-8, end with 0, and live as long as the module. Of what is told in a call 4000 bytes a text and 100
 *   notes are taken. */
#ifndef FOREDRAW_C_MODULE_H
#define FOREDRAW_C_MODULE_H

#include <foredraw/c/plugin.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What the function that a module exports is declared with, in C: before "const foredraw_module*". */
#ifdef __cplusplus
#define FOREDRAW_EXPORT extern "C" __attribute__((visibility("default")))
#else
#define FOREDRAW_EXPORT __attribute__((visibility("default")))
#endif

/* The version of this header. Modules of another major version are refused, which its function's name tells. */
enum { FOREDRAW_MODULE_MAJOR = 1, FOREDRAW_MODULE_MINOR = 1 };

typedef struct foredraw_module {
  uint32_t size;         /* sizeof(foredraw_module) */
  uint32_t major;        /* FOREDRAW_MODULE_MAJOR */
  uint32_t minor;        /* the least that it needs; one above that of the program is refused */
  uint32_t plugin_count; /* 1 to 1000 */
  const char* vendor;    /* lower-case letters and digits: "acme"; each plugin is called by it: "acme-radial" */
  const char* version;   /* "1.2.0", for reports */
  const foredraw_plugin* const* plugins;
} foredraw_module;

/* What a module exports, under this very name. Called once in each process. */
const foredraw_module* foredraw_module_v1(void);

#ifdef __cplusplus
}
#endif

#endif
