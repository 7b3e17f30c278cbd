/* Foredraw as a library for C, and for what calls C: scenes from files or memory, pipelines, figures. C99; link
 * libforedraw, which has the functions of functions.h as well.
 *
 *   foredraw_context* context = foredraw_context_new(NULL);
 *   foredraw_scene *scene = NULL, *cheaper = NULL;
 *   foredraw_text text = {0};
 *   int status = foredraw_read(context, "house.glb", &scene, &text);
 *   if (status == FOREDRAW_DONE) {
 *     foredraw_text_free(&text);
 *     status = foredraw_optimize(context, scene, "weld, lookahead, occlusion-order, vertex-fetch", &cheaper, &text);
 *   }
 *   if (status == FOREDRAW_DONE) ...        foredraw_write(), or foredraw_scene_draw()
 *   puts(text.data);
 *
 * - Texts are UTF-8. Those that come out are JSON (docs/reference/report.md), even where something failed:
 * "diagnostics" says what is wrong, where, and what to do about it. Each out-parameter may be NULL where the caller
 * does not want it.
 * - Scenes never change; what is made of one is another. All handles may be used on several threads at once. Each is
 *   freed once, in any sequence; freeing NULL does nothing.
 * - No exception leaves a function. Statuses: status.h. */
#ifndef FOREDRAW_C_FOREDRAW_H
#define FOREDRAW_C_FOREDRAW_H

#include <foredraw/c/mesh.h>
#include <foredraw/c/module.h>
#include <foredraw/c/plugin.h>
#include <foredraw/c/status.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of the library, 10000 * major + 100 * minor + patch. */
uint32_t foredraw_version(void);

/* Plugins and threads. */
typedef struct foredraw_context foredraw_context;
typedef struct foredraw_scene foredraw_scene;

/* A text that came out, with a 0 behind its last byte; to be freed by foredraw_text_free(), which empties it. */
typedef struct foredraw_text {
  const char* data; /* NULL: none */
  uint64_t length;  /* bytes */
} foredraw_text;
void foredraw_text_free(foredraw_text* text);

typedef struct foredraw_settings {
  uint32_t size;    /* sizeof(foredraw_settings) */
  uint32_t threads; /* at most; 0: one for each processor */
  /* Called as stages begin and end, on the thread that called the function: what is going on, and which part of the
   * whole is done, 0 to 1. A number other than 0 cancels it. May be NULL. */
  int (*progress)(void* user, const char* what, double part);
  void* user;
} foredraw_settings;

/* NULL where memory runs out. `settings` may be NULL. */
foredraw_context* foredraw_context_new(const foredraw_settings* settings);
void foredraw_context_free(foredraw_context* context);

/* Adds a technique of the caller's own, which stages and evaluators then name like any other. `plugin` and all that it
 * points to have to live as long as the context. To be done before another thread uses the context. */
int foredraw_add_plugin(foredraw_context* context, const foredraw_plugin* plugin, foredraw_text* problems);

/* Adds the techniques of a module's file, or of all in a folder. `inside` 0: they run in processes of their own, for
 * which the program foredraw-module has to be where it is installed, or where FOREDRAW_MODULE_WORKER says; 1: in this
 * one, which then trusts them. FOREDRAW_MISTAKE where something is wrong with one; the others are added all the same.
 * To be done before another thread uses the context. */
int foredraw_load_module(foredraw_context* context, const char* path, uint32_t inside, foredraw_text* problems);

/* For programs that serve modules written in another language, as foredraw-module serves those in C: answers the calls
 * of the program that began this process, until that ends it. FOREDRAW_FAILED where none did. */
int foredraw_serve_module(const foredraw_module* module);

/* Ends whatever runs in the context at this time, within about a second: it returns FOREDRAW_CANCELLED. From any
 * thread. A call that is to be ended alone gets a context of its own: scenes belong to none. */
void foredraw_cancel(foredraw_context* context);

/* Scenes. `problems` is {"diagnostics": [...]}: errors, and warnings where there was none. */

/* Reads glTF, OBJ, PLY, OFF, STL, an image or a frame list. */
int foredraw_read(foredraw_context* context, const char* path, foredraw_scene** scene, foredraw_text* problems);

/* The same of glTF in memory, .glb or .gltf. `name` is what diagnostics call it. Files beside it are not looked for. */
int foredraw_read_memory(foredraw_context* context, const void* bytes, uint64_t size, const char* name,
                         foredraw_scene** scene, foredraw_text* problems);

/* Writes it, the extension says as what: all its files or none. A scene that a pipeline made is written as the
 * pipeline's [output] says, so that the bytes are those of the program. */
int foredraw_write(foredraw_context* context, const foredraw_scene* scene, const char* path, foredraw_text* problems);

/* The same with settings instead of [output], "compression=draco, levels=msft-lod": names, values and errors are those
 * of [output] (docs/reference/pipelines.md). What is not named is as foredraw_write() has it. NULL: nothing is named.
 * FOREDRAW_MISTAKE where a setting is wrong. */
int foredraw_write_as(foredraw_context* context, const foredraw_scene* scene, const char* path, const char* settings,
                      foredraw_text* problems);

/* The bytes of the file that foredraw_write_as() would write to the path `name`, to be freed by foredraw_text_free().
 * FOREDRAW_FAILED where the scene takes several files, as .gltf does. */
int foredraw_write_memory(foredraw_context* context, const foredraw_scene* scene, const char* name,
                          const char* settings, foredraw_text* file, foredraw_text* problems);

/* A scene of draws in memory, which is copied. */
int foredraw_make_scene(foredraw_context* context, const foredraw_draw* draws, uint64_t draw_count,
                        foredraw_scene** scene, foredraw_text* problems);

uint64_t foredraw_scene_draws(const foredraw_scene* scene);

/* What a draw is now, at full detail: memory of the scene's, good while a handle of it lives. `draw->size` has to be
 * set. Draws of lines and points are refused (FOREDRAW_MISTAKE). */
int foredraw_scene_draw(const foredraw_scene* scene, uint64_t number, foredraw_draw* draw);

/* Where triangles and vertices went: arrays of the scene's of one number for each triangle, [new] = old, and for each
 * vertex that there was, [old] = new, or 0xffffffff where it was left out; NULL where all are as they were. */
int foredraw_scene_moves(const foredraw_scene* scene, uint64_t number, const uint32_t** triangles,
                         const uint32_t** vertices, uint64_t* vertex_count);

foredraw_scene* foredraw_scene_copy(const foredraw_scene* scene); /* a handle of the same */
void foredraw_scene_free(foredraw_scene* scene);

/* Runs. A pipeline is "@default" or another preset, a line of stages, or the text of a pipeline's file
 * (docs/reference/pipelines.md). `report` is that of the program's --json. */

/* Runs the stages. Where one failed the status is FOREDRAW_FAILED and `result` is what the others made; after
 * FOREDRAW_MISTAKE and FOREDRAW_CANCELLED it is NULL. */
int foredraw_optimize(foredraw_context* context, const foredraw_scene* scene, const char* pipeline,
                      foredraw_scene** result, foredraw_text* report);

/* Measures with these evaluators, "vertex-cache, overdraw-raster(count=30)"; NULL: those of @default. */
int foredraw_measure(foredraw_context* context, const foredraw_scene* scene, const char* evaluators,
                     foredraw_text* report);

/* Orders of one draw, without a scene. `stages` is one stage or a line of them, "lookahead,
 * occlusion-order(quality=high)", that order or cluster triangles; or one that orders vertices. Positions are needed
 * for all. Where a stage finds that nothing can be gained, what there is stays. `report` is that of
 * foredraw_optimize(), and says what is wrong with the draw. After FOREDRAW_FAILED, too, the outputs are good, of the
 * other stages; after FOREDRAW_MISTAKE and FOREDRAW_CANCELLED they are as they were. */

/* order[new] = old: a number for each triangle, or of a stage that orders vertices for each vertex. */
int foredraw_order(foredraw_context* context, const char* stages, const foredraw_triangles* triangles,
                   const foredraw_positions* positions, uint32_t* order, foredraw_text* report);

/* The same with stages of which one clusters: cluster c holds the triangles offsets[c] to offsets[c + 1] - 1 of that
 * order, which may be NULL where no stage orders. `offsets` has room for one number more than there are triangles, of
 * which *cluster_count + 1 are written. */
int foredraw_cluster(foredraw_context* context, const char* stages, const foredraw_triangles* triangles,
                     const foredraw_positions* positions, uint32_t* order, uint32_t* offsets, uint32_t* cluster_count,
                     foredraw_text* report);

/* Each pipeline on each scene, side by side; all measure as the first does. Stages run in so many `rounds` (0: 1), and
 * their times are the medians. `comparison` is that of the program's compare --json. A pipeline that can not be planned
 * for some scene is lost there: the status is FOREDRAW_FAILED. */
int foredraw_compare(foredraw_context* context, const foredraw_scene* const* scenes, uint64_t scene_count,
                     const char* const* pipelines, uint64_t pipeline_count, uint32_t rounds, foredraw_text* comparison);

#ifdef __cplusplus
}
#endif

#endif
