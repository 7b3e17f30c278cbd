#include <foredraw/job/job.h>

#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>

#include <algorithm>
#include <numeric>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

const char* name_of(JobKind kind) {
  switch (kind) {
    case JobKind::optimize: return "optimize";
    case JobKind::measure: return "measure";
    case JobKind::compare: break;
  }
  return "compare";
}

std::uint64_t bytes_of(std::span<const OutputFile> files) {
  return std::accumulate(files.begin(), files.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const OutputFile& file) { return sum + file.bytes.size(); });
}

std::vector<fs::path> paths_of(const std::vector<FileRead>& files, bool were_read) {
  std::vector<fs::path> paths;
  for (const FileRead& file : files) {
    if ((file.found == FileRead::Found::content) == were_read) paths.push_back(file.path);
  }
  return paths;
}

}  // namespace

Job::Job(const JobSetup& setup, JobKind kind, std::string input, Diagnostics found)
    : setup_(setup),
      kind_(kind),
      path_(std::move(input)),
      own_(setup.input.files ? std::make_shared<FilesRead>() : nullptr),
      diagnostics_(std::move(found)) {
  report_.command = name_of(kind);
  report_.input.path = path_;
}

bool Job::end(JobStatus status) {
  status_ = is_cancelled() ? JobStatus::cancelled : status;
  Report ended;
  ended.command = name_of(kind_);
  ended.input = report_.input;
  ended.diagnostics = diagnostics_.all();
  report_ = std::move(ended);
  return false;
}

bool Job::refuse(const Diagnostics& why) {
  for (const Diagnostic& one : why.all()) diagnostics_.add(one);
  return end(JobStatus::mistake);
}

bool Job::recall(const std::vector<JobOutput>& outputs) {
  auto found = setup_.cache == nullptr ? std::nullopt : setup_.cache->recalled(path_, outputs);
  if (!found) return false;
  is_recalled_ = true;
  json_ = std::move(found->json);
  text_ = std::move(found->text);
  files_ = std::move(found->files);
  recalled_read_ = std::move(found->read);
  recalled_sought_ = std::move(found->sought);
  return true;
}

bool Job::read() {
  if (is_cancelled()) return end(JobStatus::cancelled);
  SceneInput how = setup_.input;
  how.files = own_;
  auto file = read_scene(path_, diagnostics_, how);
  if (!file || is_cancelled()) return end(JobStatus::unreadable);
  take({path_, file->bytes, to_text(file->stamp)}, std::move(file->scene));
  return true;
}

void Job::take(const FileRecord& file, Scene scene) {
  report_.input = file;
  report_.diagnostics = diagnostics_.all();
  scene_ = std::move(scene);
  analyses_.emplace(image_decoder(file.path, setup_.input.root, own_));
}

bool Job::plan(const Pipeline& pipeline) {
  plan_ = foredraw::plan(pipeline, setup_.registry, scene_, diagnostics_, setup_.lender);
  report_.diagnostics = diagnostics_.all();
  return plan_ || end(JobStatus::mistake);
}

bool Job::run() {
  if (setup_.keeps_input) before_ = scene_;
  const auto work = kind_ == JobKind::measure ? foredraw::measure : foredraw::optimize;
  Result result = work(*plan_, std::move(scene_), {setup_.executor, *analyses_, setup_.cancel, setup_.progress});
  for (const Diagnostic& one : result.report.diagnostics) diagnostics_.add(one);
  result.report.command = report_.command;
  result.report.input = report_.input;
  report_ = std::move(result.report);
  report_.diagnostics = diagnostics_.all();
  scene_ = std::move(result.scene);
  analyses_->clear();
  status_ = is_cancelled() ? JobStatus::cancelled : result.failed ? JobStatus::in_part : JobStatus::done;
  return status_ != JobStatus::cancelled;
}

bool Job::encode(const std::vector<JobOutput>& outputs) {
  const ProductRows rows = setup_.registry.products();
  for (const JobOutput& output : outputs) {
    auto files = foredraw::encode(scene_, output, plan_->pipeline.output, rows, diagnostics_);
    if (!files) return end(JobStatus::unwritable);
    if (report_.output.path.empty() && output.is_scene()) report_.output = {output.path, bytes_of(*files)};
    files_.push_back(std::move(*files));
  }
  report_.diagnostics = diagnostics_.all();
  if (setup_.cache != nullptr && status_ == JobStatus::done) {
    json_ = to_json(report_);
    setup_.cache->keep(path_, outputs, files_, {own_->all(), setup_.input.files->all()}, scene_, report_, json_);
  }
  return true;
}

Contest Job::compare(std::span<const NamedPipeline> pipelines, int rounds) {
  Contest made = contest(report_.input, scene_, pipelines, setup_.registry, setup_.lender, rounds,
                         {setup_.executor, *analyses_, setup_.cancel, setup_.progress});
  made.comparison.diagnostics = diagnostics_.all();
  const auto is_lost = [](const Branch& branch) { return branch.is_lost; };
  const bool is_whole = !made.failed && std::ranges::none_of(made.comparison.branches, is_lost);
  status_ = is_cancelled() ? JobStatus::cancelled : is_whole ? JobStatus::done : JobStatus::in_part;
  return made;
}

OverdrawOptions Job::overdraw_options() const {
  for (const PlannedStage& measure : plan_->measures) {
    if (const OverdrawOptions* options = overdraw_options_of(*measure.technique)) return *options;
  }
  return {};
}

std::vector<fs::path> Job::files_read() const {
  if (is_recalled_ || !own_) return recalled_read_;
  return paths_of(own_->all(), true);
}

std::vector<fs::path> Job::files_sought() const {
  if (is_recalled_ || !own_) return recalled_sought_;
  return paths_of(own_->all(), false);
}

}  // namespace foredraw
