/* A module of version 1.0 with whatever that version has: every kind, every type of option, all that it may tell its
 * host. everything-x86_64.so was made of it and of the headers of 1.0, and is never made again: it has
 * to load in every program that speaks version 1 of modules.
 *
 *   cc -std=c99 -O2 -ffp-contract=off -shared -fPIC -s -nostdlib -I framework -o everything-x86_64.so everything.c */
#include <foredraw/c/module.h>

#define CALL                                                                                     \
  void *user, const foredraw_draw *draw, const foredraw_value *options, foredraw_answer *answer, \
      const foredraw_host *host

static int is_word(const char* text, char first) { return text != 0 && text[0] == first; }

/* Backwards, where all options have the values that they are given in the test; else as it is. */
static int backwards(CALL) {
  const int as_given = options[0].integer == 1 && options[1].integer == -7 && options[2].number == 2.5 &&
                       is_word(options[3].text, 't') && is_word(options[4].text, 'b');
  (void)user;
  if (draw->size < sizeof *draw || host->size < sizeof *host) return FOREDRAW_FAILED;
  if (host->cancelled(host->self)) return FOREDRAW_CANCELLED;
  for (uint64_t t = 0; t < draw->triangle_count; ++t) {
    answer->values[t] = (uint32_t)(as_given ? draw->triangle_count - 1 - t : t);
  }
  host->note(host->self, "turned", as_given ? "it is turned" : "it is not turned");
  return FOREDRAW_DONE;
}

static int vertices_backwards(CALL) {
  (void)user, (void)options, (void)host;
  for (uint32_t v = 0; v < draw->vertex_count; ++v) answer->values[v] = draw->vertex_count - 1 - v;
  return FOREDRAW_DONE;
}

/* Pairs of triangles. */
static int pairs(CALL) {
  uint64_t count = 0;
  (void)user, (void)options, (void)host;
  for (uint64_t t = 0; t < draw->triangle_count; t += 2) answer->values[count++] = (uint32_t)t;
  answer->values[count++] = (uint32_t)draw->triangle_count;
  answer->count = count;
  return FOREDRAW_DONE;
}

static int never(CALL) {
  (void)user, (void)draw, (void)options, (void)answer;
  host->keep(host->self, "it was good in the first version");
  return FOREDRAW_DONE;
}

static int fails(CALL) {
  (void)user, (void)draw, (void)options, (void)answer;
  host->fail(host->self, "it failed in the first version");
  return FOREDRAW_FAILED;
}

static int corners(CALL) {
  (void)user, (void)options, (void)answer;
  host->count(host->self, "corners", 3.0 * (double)draw->triangle_count);
  host->measure(host->self, "share", (double)draw->triangle_count, (double)draw->vertex_count, 0.25);
  return FOREDRAW_DONE;
}

static const char* const words[] = {"a", "b"};
static const foredraw_option options[] = {
    {"flag", "A flag", 0, FOREDRAW_BOOLEAN, 0, 0, {0, 0.0, 0}, 0.0, 0.0},
    {"whole", "A whole number", "steps", FOREDRAW_INTEGER, 0, 0, {3, 0.0, 0}, -10.0, 10.0},
    {"real", "A number", "m", FOREDRAW_NUMBER, 0, 0, {0, 1.5, 0}, 0.0, 4.0},
    {"text", "A text", 0, FOREDRAW_TEXT, 0, 0, {0, 0.0, "none"}, 0.0, 0.0},
    {"word", "A word", 0, FOREDRAW_CHOICE, 2, words, {0, 0.0, "a"}, 0.0, 0.0}};
static const foredraw_metric metrics[] = {{"corners", "corners", "How many there are", 0},
                                          {"share", "triangles per vertex", "How many there are", 1}};

static const foredraw_plugin plugins_of_it[] = {
    {sizeof(foredraw_plugin), FOREDRAW_TRIANGLE_ORDERER, "first-backwards", "Turns the order", "own", 0, 0,
     "cache-ordered clustered", options, 0, 5, 0, 1, 0, backwards},
    {sizeof(foredraw_plugin), FOREDRAW_VERTEX_ORDERER, "first-vertices", "Turns the vertices", "own", 0, 0,
     "fetch-ordered", 0, 0, 0, 0, 0, 0, vertices_backwards},
    {sizeof(foredraw_plugin), FOREDRAW_CLUSTERER, "first-pairs", "Clusters of two", "own", 0, "clustered", 0, 0, 0, 0,
     0, 0, 0, pairs},
    {sizeof(foredraw_plugin), FOREDRAW_TRIANGLE_ORDERER, "first-never", "Never does", "own", "clustered", 0, 0, 0, 0, 0,
     0, 0, 0, never},
    {sizeof(foredraw_plugin), FOREDRAW_TRIANGLE_ORDERER, "first-fails", "Fails", "own", 0, 0, 0, 0, 0, 0, 0, 0, 0,
     fails},
    {sizeof(foredraw_plugin), FOREDRAW_EVALUATOR, "first-corners", "Counts corners", "own", 0, 0, 0, 0, metrics, 0, 2,
     0, 0, corners}};
static const foredraw_plugin* const plugins[] = {plugins_of_it,     plugins_of_it + 1, plugins_of_it + 2,
                                                 plugins_of_it + 3, plugins_of_it + 4, plugins_of_it + 5};
static const foredraw_module module = {sizeof(foredraw_module), 1, 0, 6, "first", "1.0.0", plugins};

FOREDRAW_EXPORT const foredraw_module* foredraw_module_v1(void) { return &module; }
