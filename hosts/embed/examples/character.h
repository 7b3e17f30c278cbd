/* A small engine for character_orders.c, as C sees it: one character of a scene that `foredraw optimize` wrote, in any
 * pose and from any side. Made of Foredraw's reader, poses and rasteriser; yours has its own. */
#ifndef FOREDRAW_EXAMPLES_CHARACTER_H
#define FOREDRAW_EXAMPLES_CHARACTER_H

#include <foredraw/runtime/order_table.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct character character;

/* Fragments of one picture. */
typedef struct character_fragments {
  double drawn;   /* that pass the depth test */
  double visible; /* that stay */
} character_fragments;

/* What the first table of draw orders chooses for. NULL where there is none, or no scene to read: stderr says which. */
character* character_load(const char* path);
void character_free(character* hero);

/* Good as long as the character. */
const foredraw_order_table* character_table(const character* hero);

/* Poses it as the table's clip has it at the time in seconds. Where the table has no clips it stays as it stands.
 * Nothing but 0 says that it did not work, and stderr why. */
int character_pose(character* hero, uint32_t clip, float time);

/* Draws it orthographically, as it was posed last, in the order that is asked for: below the table's k. Its parts are
 * drawn in the sequence, one for each of the table's; NULL: as the file has them. */
int character_draw(character* hero, const float towards_camera[3], uint32_t order, const uint16_t* sequence,
                   character_fragments* fragments);

#ifdef __cplusplus
}
#endif

#endif
