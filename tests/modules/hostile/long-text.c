/* Tells a text of a gigabyte. */
#include "hostile.h"
static char* text;
static int run(RUN) {
  const size_t bytes = (size_t)1 << 30;
  if (text == NULL) {
    text = malloc(bytes);
    memset(text, 'm', bytes);
    text[bytes - 1] = 0;
  }
  host->note(host->self, "long", text);
  return AS_IT_IS;
}
MODULE("long-text")
