/* Images of sprites cut into frames, and frames trimmed to what shows, for C. Part of functions.h. */
#ifndef FOREDRAW_C_SPRITES_H
#define FOREDRAW_C_SPRITES_H

#include <foredraw/c/status.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What of an image shows: a number for each texel, as its alpha. */
typedef struct foredraw_alpha {
  const void* first;      /* of the upper left texel, at any alignment */
  uint32_t width, height; /* 1 to 32768 */
  uint32_t bytes;         /* of a number: 1 (255 shows most) or 2 (65535) */
  uint32_t texel_stride;  /* bytes from one texel to the next; 0: `bytes` */
  uint64_t row_stride;    /* bytes from one row to the next; 0: none between them */
} foredraw_alpha;

/* Of an image, in texels from its upper left corner. */
typedef struct foredraw_rectangle {
  uint32_t x, y, width, height;
} foredraw_rectangle;

/* The parts of an image of many sprites, in reading order, each with a margin of one texel. A texel shows that is above
 * `threshold`, 0 to 1; parts have `gutter` empty texels between them, 1 to 65535 (1). *frame_count is the room, and
 * then how many there are: where the room does not suffice, nothing else is written (FOREDRAW_TOO_LARGE). More than
 * 16384 are FOREDRAW_TOO_LARGE with a *frame_count of 0. */
int foredraw_sprite_frames(foredraw_rectangle* frames, uint32_t* frame_count, const foredraw_alpha* image,
                           double threshold, uint32_t gutter);

enum { FOREDRAW_WRAP_REPEAT, FOREDRAW_WRAP_MIRRORED, FOREDRAW_WRAP_CLAMPED };
enum { FOREDRAW_UV_FLOAT32, FOREDRAW_UV_FLOAT16, FOREDRAW_UV_UNORM16 };

typedef struct foredraw_trim_options {
  uint32_t size;       /* sizeof(foredraw_trim_options) */
  uint32_t vertices;   /* of a polygon, at most; 3 to 16 */
  double threshold;    /* what is above it shows, 0 to 1 */
  double padding;      /* texels more on each side, 0 to 64 */
  double least_saving; /* of the frame, below which it stays as it is; 0 to 1 */
  uint32_t mip_levels; /* smaller versions of the image that may be sampled, 0 to 14 */
  uint32_t wrap_u;     /* FOREDRAW_WRAP_REPEAT and so on */
  uint32_t wrap_v;
  uint32_t is_nearest; /* 1: texels are not blended */
  uint32_t uv;         /* how coordinates are stored: FOREDRAW_UV_FLOAT32 and so on */
  uint32_t reserved;   /* 0 */
} foredraw_trim_options;
#define FOREDRAW_TRIM_DEFAULTS                                                                       \
  {                                                                                                  \
    sizeof(foredraw_trim_options), 8, 0, 0, .05, 2, FOREDRAW_WRAP_CLAMPED, FOREDRAW_WRAP_CLAMPED, 0, \
        FOREDRAW_UV_FLOAT32, 0                                                                       \
  }

enum {
  FOREDRAW_TRIMMED,   /* to a polygon */
  FOREDRAW_RECTANGLE, /* no polygon keeps clear of what shows beside the frame: the upright rectangle */
  FOREDRAW_EMPTY,     /* nothing shows */
  FOREDRAW_FULL,      /* all of it shows: the frame stays */
  FOREDRAW_NO_SAVING  /* too little would be saved: the frame stays */
};
typedef struct foredraw_trimmed {
  uint32_t outcome;      /* FOREDRAW_TRIMMED and so on */
  uint32_t corner_count; /* 0 where the frame stays or nothing shows */
  double area;           /* of what is drawn, in texels */
  double frame_area;     /* in texels */
  double lost;           /* the largest number that may show outside, at most the threshold */
} foredraw_trimmed;

/* A polygon for each frame, as small as its vertices allow, that holds all that shows. Those of frame i are the texture
 * coordinates corners[32 * i], u and v in turn, clockwise on a screen; (0, 0) is the upper left corner, (1, 1) the
 * lower right one. `corners` has room for 32 numbers a frame. `options` may be NULL: FOREDRAW_TRIM_DEFAULTS. A frame
 * outside of the image is FOREDRAW_OPTION_RANGE. Persson: Graphics Gems for Games, SIGGRAPH 2012. */
int foredraw_particle_trim(foredraw_trimmed* trimmed, double* corners, const foredraw_alpha* image,
                           const foredraw_rectangle* frames, uint32_t frame_count,
                           const foredraw_trim_options* options);

#ifdef __cplusplus
}
#endif

#endif
