/* What functions for C return. */
#ifndef FOREDRAW_C_STATUS_H
#define FOREDRAW_C_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

enum {
  FOREDRAW_DONE = 0,
  /* Of foredraw.h, whose functions say more in a text. */
  FOREDRAW_MISTAKE,   /* the caller's, as in a pipeline: nothing was done */
  FOREDRAW_FAILED,    /* something went wrong with a file or a stage */
  FOREDRAW_CANCELLED, /* the caller ended it */
  /* Of both headers. */
  FOREDRAW_NO_MEMORY,    /* memory ran out */
  FOREDRAW_NULL_POINTER, /* a pointer is NULL */
  /* Of functions.h. */
  FOREDRAW_INDEX_COUNT,  /* the number of indices is no multiple of three */
  FOREDRAW_INDEX_BYTES,  /* indices have neither 1, 2 nor 4 bytes */
  FOREDRAW_INDEX_RANGE,  /* an index is not below the number of vertices */
  FOREDRAW_TOO_LARGE,    /* more triangles or vertices than the function can number */
  FOREDRAW_OPTION_RANGE, /* an option lies outside of its range */
  FOREDRAW_NO_CLUSTERS,  /* offsets do not begin with 0, rise, and end with the number of triangles */
  FOREDRAW_NO_ORDER,     /* an order does not name everything once */
  FOREDRAW_NO_TRANSFORM  /* a place or a transform is flat or not finite */
};

/* A sentence without its full stop, in English; for any number. */
const char* foredraw_status_text(int status);

#ifdef __cplusplus
}
#endif

#endif
