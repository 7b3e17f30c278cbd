#include <foredraw/c/status.h>

const char* foredraw_status_text(int status) {
  switch (status) {
    case FOREDRAW_DONE: return "done";
    case FOREDRAW_MISTAKE: return "the request is not possible; the text that was returned says why";
    case FOREDRAW_FAILED: return "something went wrong; the text that was returned says what";
    case FOREDRAW_CANCELLED: return "cancelled";
    case FOREDRAW_NO_MEMORY: return "memory ran out";
    case FOREDRAW_NULL_POINTER: return "a pointer is NULL where data or room for the answer is needed";
    case FOREDRAW_INDEX_COUNT: return "the number of indices is not a multiple of three";
    case FOREDRAW_INDEX_BYTES: return "the size of an index must be 1, 2 or 4 bytes";
    case FOREDRAW_INDEX_RANGE: return "an index is not below the number of vertices";
    case FOREDRAW_TOO_LARGE: return "there are more triangles or vertices than the function can number";
    case FOREDRAW_OPTION_RANGE: return "an option is out of its range";
    case FOREDRAW_NO_CLUSTERS: return "cluster offsets must begin with 0, rise, and end with the number of triangles";
    case FOREDRAW_NO_ORDER: return "an order must name each element at most once, and no other";
    case FOREDRAW_NO_TRANSFORM: return "places and transforms must be finite, and transforms not flat";
  }
  return "this is not a status of Foredraw";
}
