#pragma once
// A pipeline as it was written: what to run, in which sequence, with which options. A value that says nothing yet of
// whether it can run; plan() does.

#include <foredraw/base/diagnostics.h>
#include <foredraw/frames/camera_path.h>
#include <foredraw/pipeline/module_demand.h>
#include <foredraw/scene/output_settings.h>
#include <foredraw/scene/subject.h>
#include <foredraw/technique/options.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/view_set.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// One stage: a plugin's name, its options as written, and the reserved words.
struct Stage {
  std::string use;
  Settings settings;      ///< as written; checked against the plugin's table by the planner
  std::string only;       ///< names of draws, with * and ?; empty: all
  bool required = false;  ///< an error where it would be skipped
  bool enabled = true;
  bool blended = false;  ///< also reorder blended draws
  int level = 0;         ///< of detail, that an evaluator measures

  Where where;                                ///< of the stage in the text
  std::map<std::string, Where> option_where;  ///< of each option's value
};

struct SubjectChoice {
  SubjectUnit subject = SubjectUnit::character;
  friend bool operator==(const SubjectChoice&, const SubjectChoice&) = default;
};

struct Pipeline {
  std::string about;
  std::vector<Stage> stages;
  std::vector<Stage> measure;
  std::vector<ModuleDemand> modules;  ///< that have to be loaded
  ViewSet views;                      ///< what orders are optimised for
  PoseSet poses;                      ///< and in which poses
  SubjectChoice subjects;             ///< and what is seen as one there
  FrameSet frames;                    ///< through which evaluators walk
  std::optional<Stage> overdraw;      ///< [services]: who answers for measured overdraw
  OutputSettings output;              ///< how the scene is written; no stage sees it
  std::int64_t seed = 0;

  Where views_where{.inside = "views"};  ///< in the text
  Where poses_where{.inside = "poses"};
  Where frames_where{.inside = "frames"};
};

/// Equal in all that decides what runs; places in the text are not compared.
bool same_pipeline(const Pipeline& a, const Pipeline& b);

}  // namespace foredraw
