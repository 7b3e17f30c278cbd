/* A technique in C, or in what C can call back into: an orderer of triangles or vertices, a clusterer, an evaluator, a
 * remesher. It runs in pipelines beside the others, by its name; what it answers is checked as theirs is.
 *
 * Its functions are called in the caller's own process. Input is read only, though nothing stops who writes it: then
 * nobody knows what comes out.
 *
 * Structs grow at their ends alone. "1.1" stands where something came with that version of module.h; what was compiled
 * with the headers before that goes on working. */
#ifndef FOREDRAW_C_PLUGIN_H
#define FOREDRAW_C_PLUGIN_H

#include <foredraw/c/draw.h>
#include <foredraw/c/status.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  FOREDRAW_TRIANGLE_ORDERER = 1, /* answers with an order of the triangles, [new] = old */
  FOREDRAW_VERTEX_ORDERER, /* with an order of the vertices, [new] = old; indices are those of all draws that use them
                            */
  FOREDRAW_CLUSTERER,      /* with cluster_count + 1 offsets into the triangles */
  FOREDRAW_EVALUATOR,      /* with figures alone */
  FOREDRAW_REMESHER /* 1.1: with other triangles, of vertices that there are: indices of the new vertices, and from
                       which old one each of these comes. Neither may be more than before. */
};

/* 1.1: what a technique says of itself besides. */
enum {
  FOREDRAW_LOSSLESS = 1,     /* a remesher that draws the same triangles with the same vertex data: it is certified */
  FOREDRAW_USES_OVERDRAW = 2 /* it asks host->count_overdraw */
};

enum { FOREDRAW_BOOLEAN = 1, FOREDRAW_INTEGER, FOREDRAW_NUMBER, FOREDRAW_TEXT, FOREDRAW_CHOICE };

/* Of an option, the member of its type: `integer` of booleans (0, 1) and integers, `number`, `text` of texts and
 * choices. */
typedef struct foredraw_value {
  int64_t integer;
  double number;
  const char* text;
} foredraw_value;

typedef struct foredraw_option {
  const char* name; /* lower-case letters, digits and hyphens */
  const char* doc;  /* one sentence */
  const char* unit; /* may be NULL */
  uint32_t type;    /* FOREDRAW_NUMBER and so on */
  uint32_t choice_count;
  const char* const* choices; /* of a choice */
  foredraw_value initial;     /* where a pipeline does not say */
  double least, most;         /* of integers and numbers, both included */
} foredraw_option;

typedef struct foredraw_metric {
  const char* name; /* "acmr" */
  const char* unit; /* may be NULL */
  const char* doc;
  uint32_t higher_is_better;
} foredraw_metric;

/* Room for the answer, full of 0xffffffff at first: what is not written is refused. */
typedef struct foredraw_answer {
  uint32_t* values;
  uint64_t count; /* the room; a clusterer and a remesher set it to how many they wrote */
  /* 1.1. Of a remesher; else NULL and 0. */
  uint32_t* vertex_from; /* [new vertex] = old one, of which every attribute and morph target is copied */
  uint64_t vertex_count; /* the room; to be set to how many were written */
} foredraw_answer;

/* What a technique may ask and tell; good within the call, on its thread. Texts are copied. */
typedef struct foredraw_host {
  uint32_t size; /* sizeof(foredraw_host) of the library */
  uint32_t reserved;
  uint64_t seed;                                /* for random numbers: of the pipeline's seed, the stage and the draw */
  void* self;                                   /* for the functions below */
  int (*cancelled)(void* self);                 /* other than 0: return FOREDRAW_CANCELLED soon */
  void (*keep)(void* self, const char* reason); /* nothing can be gained here: what there is stays */
  void (*fail)(void* self, const char* message); /* then return FOREDRAW_FAILED */
  void (*note)(void* self, const char* code, const char* message);
  void (*count)(void* self, const char* metric, double number); /* over several draws the sum */
  void (*measure)(void* self, const char* metric, double numerator, double denominator,
                  double error); /* a ratio, with its standard error; over several draws sum / sum */
  /* 1.1: the fragments of the draw alone, over all views of the pipeline, where its triangles are drawn in that order,
   * [new] = old; NULL: as they stand. Of orderers of triangles and evaluators that say FOREDRAW_USES_OVERDRAW. What is
   * seen is captured at the first call, so that others cost little. FOREDRAW_MISTAKE: it may not ask;
   * FOREDRAW_NO_ORDER; FOREDRAW_FAILED, FOREDRAW_CANCELLED: there is no answer. */
  int (*count_overdraw)(void* self, const uint32_t* order, uint64_t* shaded, uint64_t* visible);
} foredraw_host;

typedef struct foredraw_plugin {
  uint32_t size;         /* sizeof(foredraw_plugin) */
  uint32_t kind;         /* FOREDRAW_TRIANGLE_ORDERER and so on */
  const char* name;      /* lower-case letters, digits and hyphens; that of no other plugin */
  const char* summary;   /* one sentence */
  const char* reference; /* paper and section, or "own" */
  const char* needs; /* traits with blanks between, such as "clustered", without which a plan is refused; may be NULL */
  const char* provides; /* that hold afterwards; may be NULL */
  const char* breaks;   /* that may hold no longer; may be NULL */
  const foredraw_option* options;
  const foredraw_metric* metrics;
  uint32_t option_count;
  uint32_t metric_count;
  uint32_t runs_on_many_threads; /* 1: may be called on several at once; 0: is called on one at a time */
  void* user;                    /* handed to run */
  int (*run)(void* user, const foredraw_draw* draw, const foredraw_value* options, foredraw_answer* answer,
             const foredraw_host* host);
  /* 1.1. What is not named is 0. */
  const char* acts_on; /* traits; draws without them are skipped. "triangles" is always among them; may be NULL */
  const char* pays_if; /* of who may call host->keep: when there is something to gain; may be NULL */
  uint32_t flags;      /* FOREDRAW_LOSSLESS and so on; other bits are 0 */
  uint32_t reserved;
} foredraw_plugin;

#ifdef __cplusplus
}
#endif

#endif
