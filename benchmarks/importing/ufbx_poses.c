// The poses of an FBX file as ufbx evaluates them: a second reader, beside which what was imported is put. compare.py
// compiles it with the ufbx.h and ufbx.c of a folder that it is given.
//   ufbx_poses FILE.fbx OUT POSES
// writes the triangles of the file as it stands, and at POSES frames of each animation: metres, Y up, world space. At
// frames, because between keys FBX blends angles about axes, and glTF rotations.
//   u32 poses; each: u32 length, name of its animation; i32 animation (-1: at rest); f64 seconds from its beginning;
//   u64 triangles; f32[9] each
#include "ufbx.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void put(FILE* to, const void* bytes, size_t length) {
  if (fwrite(bytes, 1, length, to) != length) {
    fprintf(stderr, "ufbx_poses: writing failed\n");
    exit(1);
  }
}

static uint64_t triangles_of(const ufbx_scene* scene, FILE* to) {
  uint64_t count = 0;
  for (size_t n = 0; n < scene->nodes.count; ++n) {
    const ufbx_node* node = scene->nodes.data[n];
    const ufbx_mesh* mesh = node->mesh;
    if (mesh == NULL) continue;
    uint32_t* corners = (uint32_t*)malloc(sizeof(uint32_t) * 3 * (mesh->max_face_triangles + 1));
    for (size_t f = 0; f < mesh->faces.count; ++f) {
      const uint32_t made =
          ufbx_triangulate_face(corners, 3 * (mesh->max_face_triangles + 1), mesh, mesh->faces.data[f]);
      count += made;
      if (to == NULL) continue;
      for (uint32_t k = 0; k < 3 * made; ++k) {
        ufbx_vec3 at = ufbx_get_vertex_vec3(&mesh->skinned_position, corners[k]);
        if (mesh->skinned_is_local) at = ufbx_transform_position(&node->geometry_to_world, at);
        const float values[3] = {(float)at.x, (float)at.y, (float)at.z};
        put(to, values, sizeof values);
      }
    }
    free(corners);
  }
  return count;
}

static void put_pose(FILE* to, const char* name, int32_t clip, double seconds, const ufbx_scene* scene) {
  const uint32_t length = (uint32_t)strlen(name);
  const uint64_t count = triangles_of(scene, NULL);
  put(to, &length, sizeof length);
  put(to, name, length);
  put(to, &clip, sizeof clip);
  put(to, &seconds, sizeof seconds);
  put(to, &count, sizeof count);
  triangles_of(scene, to);
}

int main(int argc, char** argv) {
  if (argc != 4) return fprintf(stderr, "ufbx_poses FILE.fbx OUT POSES\n"), 2;
  const uint32_t moments = (uint32_t)atoi(argv[3]);
  ufbx_load_opts how = {0};
  how.target_axes = ufbx_axes_right_handed_y_up;
  how.target_unit_meters = 1;
  how.evaluate_skinning = true;
  ufbx_error error;
  ufbx_scene* scene = ufbx_load_file(argv[1], &how, &error);
  if (scene == NULL) return fprintf(stderr, "ufbx_poses: %s\n", error.description.data), 1;
  FILE* to = fopen(argv[2], "wb");
  if (to == NULL) return fprintf(stderr, "ufbx_poses: can not write %s\n", argv[2]), 1;
  const uint32_t poses = 1 + (uint32_t)scene->anim_stacks.count * moments;
  put(to, &poses, sizeof poses);
  put_pose(to, "", -1, 0, scene);
  for (size_t s = 0; s < scene->anim_stacks.count; ++s) {
    const ufbx_anim_stack* stack = scene->anim_stacks.data[s];
    const double rate = scene->settings.frames_per_second;
    const double lasts = stack->time_end - stack->time_begin;
    for (uint32_t m = 0; m < moments; ++m) {
      double seconds = moments < 2 ? 0 : lasts * m / (moments - 1);
      if (rate > 0) seconds = floor(seconds * rate + 1e-6) / rate;
      ufbx_evaluate_opts at = {0};
      at.evaluate_skinning = true;
      ufbx_scene* posed = ufbx_evaluate_scene(scene, stack->anim, stack->time_begin + seconds, &at, &error);
      if (posed == NULL) return fprintf(stderr, "ufbx_poses: %s\n", error.description.data), 1;
      put_pose(to, stack->name.data, (int32_t)s, seconds, posed);
      ufbx_free_scene(posed);
    }
  }
  ufbx_free_scene(scene);
  return fclose(to) == 0 ? 0 : 1;
}
