#pragma once
// The one record of a run: what `--report` and `--json` hold, and what the tables on the terminal are made from.

#include <foredraw/analysis/mesh_facts.h>
#include <foredraw/base/diagnostics.h>
#include <foredraw/report/metrics.h>
#include <foredraw/technique/attachment.h>
#include <foredraw/technique/module_file.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

/// The version of the JSON form. It grows by one when a program that read the old form would read the new one wrong.
inline constexpr int report_version = 1;

struct FileRecord {
  std::string path;
  std::uint64_t bytes = 0;  ///< of the file itself, without those beside it
  std::string hash = {};    ///< of the content of what was read, those beside it included; empty: not known
};

/// What is drawn: counts and figures, before or after.
struct StateRecord {
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;  ///< stored, whether used or not
  Metrics metrics;

  void add(const StateRecord& other) {
    triangles += other.triangles;
    vertices += other.vertices;
    metrics.add(other.metrics);
  }
};

struct LevelRecord {
  Traits traits;    ///< afterwards
  float error = 0;  ///< afterwards; as Level::error
  StateRecord before;
  StateRecord after;
};

struct DrawRecord : LevelRecord {  ///< of full detail
  std::string name;
  MeshFacts facts;                  ///< of the input: what was odd about it
  std::vector<LevelRecord> levels;  ///< the coarser ones; in no total

  LevelRecord& level(std::size_t number) {
    if (number > levels.size()) levels.resize(number);
    return number == 0 ? *this : levels[number - 1];
  }
};

/// Why a stage left something alone: one reason for all that share it.
struct SkipRecord {
  std::string code;
  std::string reason;
  std::vector<std::string> about;  ///< names of draws or subjects; none: the whole stage
};

struct NoteRecord {
  std::string about;  ///< the draw's or subject's name; empty: the scene
  std::string code;
  std::string message;
};

/// Pictures or curves that a technique attached. What branches have alike, they share.
struct AttachmentRecord {
  std::string about;  ///< the draw's or subject's name; empty: the scene
  std::shared_ptr<const Attachment> content;
};

struct StageRecord {
  std::string use;
  std::string text;  ///< as in the one-line form
  Kind kind = Kind::orderer;
  double seconds = 0;                   ///< the median, where it ran several times
  std::vector<double> rounds;           ///< seconds of each time, where it ran several times
  std::optional<std::uint64_t> memory;  ///< bytes that the process held more while it ran, at most, than before
  std::size_t changed = 0;              ///< of what it loops over: it worked on these with success
  std::size_t candidates = 0;           ///< so many there were
  std::string loops_over;               ///< what it loops over: "draws", "vertex streams"
  std::vector<SkipRecord> skipped;
  std::vector<NoteRecord> notes;
  std::vector<AttachmentRecord> attachments;
  std::vector<AttachmentRecord> attachments_before;  ///< of an evaluator: what it attached to the input
};

struct Report {
  std::string command;
  FileRecord input;
  FileRecord output;
  std::vector<FileRecord> named;    ///< scenes and images that options of stages name
  std::vector<ModuleFile> modules;  ///< files that its techniques were loaded from
  std::string pipeline;             ///< TOML; parses back
  std::int64_t seed = 0;
  int threads = 1;
  std::string machine;     ///< what it ran on, for people
  bool optimized = false;  ///< there is a before and an after; else only an after
  std::vector<StageRecord> stages;
  std::vector<StageRecord> measures;
  std::map<std::string, std::map<std::string, OptionValue>> evaluator_options;  ///< whole, defaults included
  std::vector<DrawRecord> draws;
  StateRecord before;  ///< totals
  StateRecord after;
  std::vector<Diagnostic> diagnostics;
  double seconds = 0;
  std::uint64_t peak_memory = 0;  ///< bytes
};

/// The JSON form, described in docs/reference/report.md.
std::string to_json(const Report& report);

/// The same text handed over in pieces: of many draws it is longer than all the rest of a run.
void write_json(const Report& report, const std::function<void(std::string_view)>& put);

/// The tables for people: figures before and after, stages with what they skipped and why.
std::string to_text(const Report& report);

/// Films keep the number of their frames and lose the pictures: what the JSON form tells of them is left. For who keeps
/// the reports of many files and makes no page of them.
void leave_out_pictures(Report& report);

/// What a stage changed: "the scene", "nothing", "3 of 5 draws".
std::string changed_text(const StageRecord& stage);

}  // namespace foredraw
