// How much smaller sprites become when they are drawn as polygons, and the time it takes: on the particle textures of
// the corpus, whole where they show one sprite, tile by tile where they are atlases. By number of vertices: the
// smallest polygon, and the one that Persson's search finds on a hull reduced to so many edges; beside them the upright
// rectangle and, where CGAL is there, the smallest rectangle and parallelogram. All figures go to a file, which
// particle_trim_page.py makes a page of.
//
//     particle-trim-bench --tsv=FILE [--rounds=N]
//
// Times are of all from the decoded texture on: its alpha, the hulls of what shows, and the polygons of all tiles,
// proven; contestants run one behind the other in each round, and the medians count. On one thread but for the large
// atlas. What the clock on the wall says stands beside what the processor worked, which other processes disturb less.

#include "enclosing_quadrilaterals.h"
#include "particle_textures.h"
#include "sprite_atlas.h"

#include <foredraw/base/parallel.h>
#include <plugins/processors/particle_trim/footprint.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <ctime>
#include <fstream>
#include <iostream>
#include <numeric>

namespace foredraw::bench {
namespace {

constexpr std::array thresholds = {0.0, 0.1};
constexpr std::array hull_edges = {8, 12, 16, 24, 32};
constexpr std::array mip_levels = {0, 2};  // the second by default; of that all that has eight vertices
constexpr int most_vertices = 16, most_vertices_by_persson = 8;

/// How a texture is trimmed.
struct Way {
  TrimMethod method = TrimMethod::optimal;
  int hull_edges = 0;  ///< 0: does not count
  int vertices = 8;

  ParticleTrimOptions options(double threshold, int mip_levels) const {
    ParticleTrimOptions options;
    options.method = method;
    options.vertices = vertices;
    options.threshold = threshold;
    options.mip_levels = mip_levels;
    options.least_saving = 0;  // all sprites count in the means
    if (hull_edges != 0) options.hull_edges = hull_edges;
    return options;
  }
};

std::vector<Way> all_ways() {
  std::vector<Way> ways;
  for (int n = 3; n <= most_vertices; ++n) ways.push_back({TrimMethod::optimal, 0, n});
  for (const int edges : hull_edges) {
    for (int n = 3; n <= most_vertices_by_persson; ++n) ways.push_back({TrimMethod::persson, edges, n});
  }
  return ways;
}

/// The default of either method.
std::vector<Way> ways_of_eight() { return {{TrimMethod::optimal, 0, 8}, {TrimMethod::persson, 24, 8}}; }

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// How long the same work takes, again and again: by the clock on the wall, and what all threads of this program
/// worked.
class Times {
 public:
  template <class Work>
  void add(Work&& work) {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t work_begin = std::clock();
    work();
    worked_.push_back(1000.0 * static_cast<double>(std::clock() - work_begin) / CLOCKS_PER_SEC);
    passed_.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }

  /// Medians in milliseconds, as two columns.
  std::string text() const { return fmt::format("{:.3f}\t{:.3f}", median(passed_), median(worked_)); }

 private:
  std::vector<double> passed_, worked_;
};

std::vector<TrimmedSprite> trimmed(const ParticleTexture& texture, const ParticleTrimOptions& options,
                                   const Executor& executor) {
  const AlphaImage alpha = alpha_image(texture.texels);
  const processors::particle_trim::ShownImage image(alpha, particle_sampling,
                                                    processors::particle_trim::footprint_of(options));
  std::vector<TrimmedSprite> sprites(texture.frames.size());
  executor.for_each(texture.frames.size(), [&](std::size_t i) {
    sprites[i] = particle_trim(image, std::span(&texture.frames[i], 1), options).front();
  });
  return sprites;
}

/// What shows in each frame; empty where nothing does.
std::vector<std::vector<processors::particle_trim::Point>> hulls(const ParticleTexture& texture,
                                                                 const ParticleTrimOptions& options) {
  const AlphaImage alpha = alpha_image(texture.texels);
  const processors::particle_trim::ShownImage image(alpha, particle_sampling,
                                                    processors::particle_trim::footprint_of(options));
  std::vector<std::vector<processors::particle_trim::Point>> made;
  for (const TrimFrame& frame : texture.frames) {
    std::vector<processors::particle_trim::Point> shown = image.shown_points(frame);
    for (processors::particle_trim::Point& point : shown) point = point - frame.least;
    const TrimFrame at_origin{{0, 0}, frame.most - frame.least};
    made.push_back(shown.empty() ? shown : processors::particle_trim::padded_hull(shown, at_origin, image.options()));
  }
  return made;
}

double area_of(const std::vector<processors::particle_trim::Point>& hull) {
  double doubled = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    doubled += static_cast<double>(processors::particle_trim::cross(hull[i], hull[(i + 1) % hull.size()]));
  }
  return doubled / 2;
}

double rectangle_area(const std::vector<processors::particle_trim::Point>& hull) {
  const auto [left, right] = std::ranges::minmax(hull, {}, &processors::particle_trim::Point::x);
  const auto [up, down] = std::ranges::minmax(hull, {}, &processors::particle_trim::Point::y);
  return static_cast<double>(right.x - left.x) * static_cast<double>(down.y - up.y);
}

std::string_view name(TrimMethod method) { return method == TrimMethod::optimal ? "optimal" : "persson"; }

/// What a line of figures is about.
struct Row {
  std::string texture;
  double threshold = 0;
  int mips = 0;
  std::string_view method;
  std::string hull_edges = "";
  std::string vertices = "";  ///< at most; of hulls, as many as they have
  int threads = 1;
};

class Bench {
 public:
  Bench(std::size_t rounds, std::ostream& out) : rounds_(rounds), out_(out) {
    out_ << "texture\tthreshold\tmip levels\tmethod\thull edges\tvertices\tthreads\tsprites\tarea\tleast area\tmost "
            "area\t"
            "milliseconds\tworked\n";
  }

  void run(const ParticleTexture& texture, const std::vector<Way>& ways, int threads) {
    for (const double threshold : thresholds) {
      for (const int mips : mip_levels) run(texture, mips == 0 ? ways : ways_of_eight(), threshold, mips, threads);
    }
    fmt::print(stderr, "{}\n", texture.name);
  }

 private:
  /// `ways` one behind the other in each round, so that a noisy moment hits all alike.
  void run(const ParticleTexture& texture, const std::vector<Way>& ways, double threshold, int mips, int threads) {
    const Executor executor(threads);
    const std::vector<bool> shows = write_hulls(texture, ways.front().options(threshold, mips));
    std::vector<Times> times(ways.size());
    std::vector<std::vector<TrimmedSprite>> sprites(ways.size());
    for (std::size_t round = 0; round < rounds_; ++round) {
      for (std::size_t i = 0; i < ways.size(); ++i) {
        times[i].add([&] { sprites[i] = trimmed(texture, ways[i].options(threshold, mips), executor); });
      }
    }
    for (std::size_t i = 0; i < ways.size(); ++i) {
      std::vector<double> areas;
      for (std::size_t tile = 0; tile < sprites[i].size(); ++tile) {
        if (shows[tile]) areas.push_back(sprites[i][tile].area / sprites[i][tile].frame_area);
      }
      const std::string edges = ways[i].hull_edges == 0 ? "" : std::to_string(ways[i].hull_edges);
      write({texture.name, threshold, mips, name(ways[i].method), edges, std::to_string(ways[i].vertices), threads},
            areas, times[i].text());
    }
  }

  /// The hulls, and what is round them without a search for a polygon. And whether something shows in each frame.
  std::vector<bool> write_hulls(const ParticleTexture& texture, const ParticleTrimOptions& options) {
    std::vector<std::vector<processors::particle_trim::Point>> found;
    Times alpha_times, hull_times;
    for (std::size_t round = 0; round < rounds_; ++round) {
      alpha_times.add([&] { alpha_image(texture.texels); });
      hull_times.add([&] { found = hulls(texture, options); });
    }
    std::vector<bool> shows;
    std::vector<std::size_t> corners;
    std::vector<double> areas, rectangles, turned_rectangles, parallelograms;
    for (std::size_t tile = 0; tile < found.size(); ++tile) {
      const std::vector<processors::particle_trim::Point>& hull = found[tile];
      shows.push_back(!hull.empty());
      if (hull.empty()) continue;
      const double frame_area = texture.frames[tile].area();
      corners.push_back(hull.size());
      areas.push_back(area_of(hull) / frame_area);
      rectangles.push_back(rectangle_area(hull) / frame_area);
      if (const auto around = enclosing_quadrilaterals(hull)) {
        turned_rectangles.push_back(around->rectangle / frame_area);
        parallelograms.push_back(around->parallelogram / frame_area);
      }
    }
    const auto row = [&](std::string_view method, const std::string& vertices) {
      return Row{texture.name, options.threshold, options.mip_levels, method, "", vertices};
    };
    const auto [least, most] = std::ranges::minmax(corners);
    write(row("alpha", ""), {}, alpha_times.text());
    write(row("hull", least == most ? std::to_string(least) : fmt::format("{} to {}", least, most)), areas,
          hull_times.text());
    write(row("upright rectangle", "4"), rectangles, "\t");
    if (!parallelograms.empty()) {
      write(row("turned rectangle", "4"), turned_rectangles, "\t");
      write(row("parallelogram", "4"), parallelograms, "\t");
    }
    return shows;
  }

  /// `areas` of the sprites, of their frames; `times` are two columns.
  void write(const Row& row, const std::vector<double>& areas, const std::string& times) {
    std::string three = "\t\t";
    if (!areas.empty()) {
      const auto [least, most] = std::ranges::minmax(areas);
      const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
      three = fmt::format("{:.6f}\t{:.6f}\t{:.6f}", sum / static_cast<double>(areas.size()), least, most);
    }
    out_ << fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", row.texture, row.threshold, row.mips, row.method,
                        row.hull_edges, row.vertices, row.threads, areas.size(), three, times)
         << std::flush;
  }

  std::size_t rounds_;
  std::ostream& out_;
};

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw;
  std::string tsv;
  int rounds = 7;
  for (const std::string_view word : std::span(argv + 1, argv + argc)) {
    const std::string_view value = word.substr(std::min(word.find('=') + 1, word.size()));
    if (word.starts_with("--tsv=")) {
      tsv = value;
    } else if (word.starts_with("--rounds=")) {
      std::from_chars(value.data(), value.data() + value.size(), rounds);
    } else {
      std::cerr << argv[0] << ": '" << word << "' is unknown; use --tsv=FILE, --rounds=N\n";
      return 1;
    }
  }
  std::ofstream out(tsv);
  if (!out || rounds < 1) {
    std::cerr << argv[0] << ": --tsv=FILE must name a file that can be written, and --rounds=N must be 1 or more\n";
    return 1;
  }
  std::vector<bench::ParticleTexture> textures;
  for (const std::filesystem::path& file : bench::particle_files()) textures.push_back(bench::particle_texture(file));
  bench::Bench bench(static_cast<std::size_t>(rounds), out);
  for (const bench::ParticleTexture& texture : textures) bench.run(texture, bench::all_ways(), 1);
  const bench::ParticleTexture atlas = bench::sprite_atlas(textures);
  for (const int threads : {1, 2}) bench.run(atlas, bench::ways_of_eight(), threads);
  return out.flush() ? 0 : 1;
}
