/* tool IN OUT: makes a model cheaper to draw, and prints the report. */
#include <foredraw/c/foredraw.h>

#include <stdio.h>

int main(int count, char** arguments) {
  foredraw_context* context = foredraw_context_new(NULL);
  foredraw_scene *scene = NULL, *cheaper = NULL;
  foredraw_text text = {NULL, 0};
  int status = count == 3 ? FOREDRAW_DONE : FOREDRAW_MISTAKE;
  if (status == FOREDRAW_DONE) status = foredraw_read(context, arguments[1], &scene, &text);
  if (status == FOREDRAW_DONE) {
    foredraw_text_free(&text);
    status = foredraw_optimize(context, scene, "weld, lookahead, vertex-fetch", &cheaper, &text);
  }
  if (text.data != NULL) puts(text.data);
  foredraw_text_free(&text);
  if (status == FOREDRAW_DONE) status = foredraw_write(context, cheaper, arguments[2], NULL);
  if (status != FOREDRAW_DONE) fprintf(stderr, "%s\n", foredraw_status_text(status));
  foredraw_scene_free(cheaper);
  foredraw_scene_free(scene);
  foredraw_context_free(context);
  return status;
}
