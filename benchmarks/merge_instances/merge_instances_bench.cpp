// What a frame of many placed primitives takes, in the ways in which engines draw them: draw calls, bytes of buffers,
// the time to record the commands; and what merging costs beforehand.
//
//     merge-instances-bench [--kit=city|space|both] [--instances=N,...] [--mirrored=PART] [--materials=kind|alike]
//                           [--rounds=N] [--frames=N] [--threads=N] [--markdown] [--tsv=FILE]
//
// In all ways materials are looked up by the shader, so merged draws may be of several materials too, as long as they
// are of one kind; --materials=alike parts them. Nothing is culled: every way draws all. Recording is timed alone,
// without handing the commands in, and all ways in turns; the medians count. What a driver does later, when they are
// handed in, is left out: on the processor that is most of the work, so its times say what the loader and the driver's
// list of commands take.
// --frames draws each frame so often too; a picture of 1024 x 1024 with all of the scene in it. On the processor such
// times are good for ratios alone. Without a Vulkan device there are no times of frames.

#include "frame_times.h"
#include "gpu_instancing.h"
#include "layout.h"
#include "merge_figures.h"

#include <foredraw/report/table.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace foredraw::bench {
namespace {

struct Wanted {
  std::vector<std::string> kits{"city", "space"};
  std::vector<std::uint64_t> instances{10'000, 100'000};
  double mirrored = 0;
  MergeSceneOptions merging{{}, processors::merge_instances::SharedMaterials::kind};
  int rounds = 7, frames = 0, threads = 2;
  bool is_markdown = false;
  std::string tsv;
};

template <class T>
bool read_number(std::string_view text, T& number, T least, T most) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number >= least && number <= most;
}

bool read_instances(std::string_view text, std::vector<std::uint64_t>& instances) {
  instances.clear();
  while (true) {
    const std::size_t comma = text.find(',');
    if (!read_number<std::uint64_t>(text.substr(0, comma), instances.emplace_back(), 1, 4'000'000)) return false;
    if (comma == std::string_view::npos) return true;
    text.remove_prefix(comma + 1);
  }
}

/// Whether the argument is one that there is, with a value that it may have.
bool read_argument(std::string_view word, Wanted& wanted) {
  const std::string_view name = word.substr(0, word.find('='));
  const std::string_view value = word.substr(std::min(name.size() + 1, word.size()));
  if (name == "--kit" && value == "both") return true;
  if (name == "--kit") {
    wanted.kits = {std::string(value)};
    return value == "city" || value == "space";
  }
  if (name == "--materials") {
    if (value == "alike") wanted.merging.materials = processors::merge_instances::SharedMaterials::alike;
    return value == "alike" || value == "kind";
  }
  if (name == "--tsv") {
    wanted.tsv = value;
    return !value.empty();
  }
  if (name == "--instances") return read_instances(value, wanted.instances);
  if (name == "--mirrored") return read_number(value, wanted.mirrored, 0.0, 1.0);
  if (name == "--rounds") return read_number(value, wanted.rounds, 1, 1000);
  if (name == "--frames") return read_number(value, wanted.frames, 0, 1000);
  if (name == "--threads") return read_number(value, wanted.threads, 1, 1024);
  if (word == "--markdown") wanted.is_markdown = true;
  return word == "--markdown";
}

/// One scene in one way.
struct Row {
  std::string kit;
  std::uint64_t placed = 0;
  DrawWay way = DrawWay::each;
  std::size_t calls = 0;
  FrameBytes bytes;
  FrameTime time;
};

struct MergeRow {
  std::string kit;
  std::uint64_t placed = 0;
  MergeFigures figures;
};

class Bench {
 public:
  explicit Bench(const Wanted& wanted) : wanted_(wanted) {}

  void run(const std::string& name, std::uint64_t instances) {
    const std::filesystem::path scenes = std::filesystem::path(FOREDRAW_SOURCE_DIR) / "benchmarks/corpus/scenes";
    const bool is_city = name == "city";
    const Kit kit = read_kit(scenes / (is_city ? "kaykit_city" : "kenney_space_kit"));
    const LayoutOptions options{.instances = instances, .mirrored = wanted_.mirrored};
    Scene scene = placed_scene(kit, is_city ? city_layout(kit, options) : space_layout(kit, options), name);
    const Scene instanced = with_gpu_instancing(scene);
    const MergeFigures figures = merge(scene, wanted_.merging, wanted_.threads, std::min(3, wanted_.rounds));
    std::vector<Row> rows;
    std::vector<TimedWay> ways;
    for (const DrawWay way : all_draw_ways) {
      const Scene& shown = way == DrawWay::gpu_instancing ? instanced : scene;
      TimedWay& timed = ways.emplace_back(TimedWay{&shown, frame_content(shown, way)});
      rows.push_back({name, timed.content.sequence.size(), way, timed.content.calls(), timed.content.bytes, {}});
      timed.content.sequence = {};
    }
    merges_.push_back({name, rows[0].placed, figures});
    const FrameTimes times = frame_times(ways, wanted_.rounds, wanted_.frames);
    device_ = times.device;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].time = times.of[i];
      rows_.push_back(rows[i]);
    }
  }

  void print() const {
    fmt::print("device: {}\n\n", device_);
    print({"kit", "placed", "way", "calls", "vertex MB", "index MB", "transform MB", "slot MB", "command MB", "all MB",
           "recording ms", "frame ms"},
          cells_of_ways());
    fmt::print("\n");
    print({"kit", "placed", "merged", "sets", "groups", "frequencies", "padding", "slot bytes", "merging ms",
           "of it packing ms"},
          cells_of_merges());
  }

  void write(std::ostream& out) const {
    out << "kit\tplaced\tway\tcalls\tvertex bytes\tindex bytes\ttransform bytes\tslot bytes\tcommand bytes\trecording "
           "ms\t"
           "frame ms\tsets\tgroups\tfrequencies\tpadding\tslot bytes of one\tmerging ms\tpacking ms\n";
    std::size_t scene = 0;
    for (const Row& row : rows_) {
      std::string merging = "\t\t\t\t\t\t";
      if (row.way == DrawWay::merged) {
        const MergeFigures& m = merges_[scene++].figures;
        merging = fmt::format("{}\t{}\t{}\t{:.6f}\t{:.3f}\t{:.3f}\t{:.3f}", m.sets, m.groups, m.frequencies, m.padding,
                              m.slot_bytes, m.milliseconds, m.packing);
      }
      const FrameBytes& bytes = row.bytes;
      out << fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", row.kit, row.placed, to_text(row.way),
                         row.calls, bytes.vertices, bytes.indices, bytes.transforms, bytes.slots, bytes.commands,
                         text(row.time.recording), text(row.time.frame), merging);
    }
  }

 private:
  using Cells = std::vector<std::vector<std::string>>;

  static std::string text(const std::optional<double>& milliseconds) {
    return milliseconds ? fmt::format("{:.4f}", *milliseconds) : "";
  }
  static std::string megabytes(std::uint64_t bytes) {
    return bytes == 0 ? "" : fmt::format("{:.3f}", static_cast<double>(bytes) * 1e-6);
  }

  Cells cells_of_ways() const {
    Cells cells;
    for (const Row& row : rows_) {
      const FrameBytes& bytes = row.bytes;
      cells.push_back({row.kit, std::to_string(row.placed), std::string(to_text(row.way)), std::to_string(row.calls),
                       megabytes(bytes.vertices), megabytes(bytes.indices), megabytes(bytes.transforms),
                       megabytes(bytes.slots), megabytes(bytes.commands), megabytes(bytes.all()),
                       row.time.why_not.empty() ? text(row.time.recording) : row.time.why_not, text(row.time.frame)});
    }
    return cells;
  }

  Cells cells_of_merges() const {
    Cells cells;
    for (const MergeRow& row : merges_) {
      const MergeFigures& m = row.figures;
      cells.push_back({row.kit, std::to_string(row.placed), std::to_string(m.merged), std::to_string(m.sets),
                       std::to_string(m.groups), m.frequencies, fmt::format("{:.2f} %", 100 * m.padding),
                       fmt::format("{:.2f}", m.slot_bytes), fmt::format("{:.1f}", m.milliseconds),
                       fmt::format("{:.1f}", m.packing)});
    }
    return cells;
  }

  void print(const std::vector<std::string>& heads, const Cells& rows) const {
    if (!wanted_.is_markdown) {
      Table table(heads);
      for (const auto& row : rows) table.add(row);
      fmt::print("{}", table.text());
      return;
    }
    fmt::print("| {} |\n|{}\n", fmt::join(heads, " | "), [&] {
      std::string rule;
      for (std::size_t i = 0; i < heads.size(); ++i) rule += "---|";
      return rule;
    }());
    for (const auto& row : rows) fmt::print("| {} |\n", fmt::join(row, " | "));
  }

  const Wanted& wanted_;
  std::string device_;
  std::vector<Row> rows_;
  std::vector<MergeRow> merges_;
};

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw::bench;
  Wanted wanted;
  for (const std::string_view word : std::span(argv + 1, argv + argc)) {
    if (read_argument(word, wanted)) continue;
    std::cerr
        << argv[0] << ": '" << word
        << "' is unknown or out of range; use --kit=city|space|both, --instances=1..4000000,..., --mirrored=0..1, "
           "--materials=kind|alike, --rounds=1..1000, --frames=0..1000, --threads=1..1024, --markdown, --tsv=FILE\n";
    return 1;
  }
  try {
    Bench bench(wanted);
    for (const std::string& kit : wanted.kits) {
      for (const std::uint64_t instances : wanted.instances) bench.run(kit, instances);
    }
    bench.print();
    if (wanted.tsv.empty()) return 0;
    std::ofstream out(wanted.tsv);
    bench.write(out);
    if (!out.flush()) throw std::runtime_error("'" + wanted.tsv + "' cannot be written");
  } catch (const std::exception& problem) {
    std::cerr << argv[0] << ": " << problem.what() << '\n';
    return 2;
  }
}
