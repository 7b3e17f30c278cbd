#include <foredraw/frames/rendering_costs.h>

#include <foredraw/runtime/lod_benefit.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <vector>

namespace foredraw {

namespace {

constexpr double most = 1e9;  // a second for each: whatever is above was not measured
constexpr std::size_t longest_text = 65536;

std::string number_text(double number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

/// On one line, without what begins a comment.
std::string one_line(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 32 || c == '#') c = ' ';
  }
  const auto first = name.find_first_not_of(' '), last = name.find_last_not_of(' ');
  return first == std::string::npos ? std::string() : name.substr(first, last - first + 1);
}

std::optional<double> number_in(const std::string& word) {
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_one = error == std::errc() && end == word.data() + word.size() && number >= 0 && number <= most;
  return is_one ? std::optional(number) : std::nullopt;
}

/// What may stand behind each word.
const std::map<std::string, std::string, std::less<>>& expected() {
  static const std::map<std::string, std::string, std::less<>> forms = [] {
    std::map<std::string, std::string, std::less<>> all = {{"machine", "machine NAME"},
                                                           {"stages", "stages max' or 'stages sum"},
                                                           {"frame", "frame NANOSECONDS"},
                                                           {"draw", "draw NANOSECONDS"},
                                                           {"posed", "posed NANOSECONDS"}};
    for (const Rendering rendering : all_renderings) {
      const std::string name(to_text(rendering));
      all.emplace(name, name + " TRIANGLE VERTEX PIXEL");
    }
    return all;
  }();
  return forms;
}

/// Takes up one line; false where it is none of those.
bool take(std::string_view word, const std::string& rest, RenderingCosts& costs) {
  if (word == "machine") {
    costs.machine = one_line(rest);
    return !costs.machine.empty();
  }
  std::istringstream split(rest);
  std::vector<std::string> words;
  for (std::string each; split >> each;) words.push_back(each);
  if (word == "stages") {
    costs.stages = words == std::vector<std::string>{"sum"} ? Stages::sum : Stages::max;
    return words.size() == 1 && words[0] == to_text(costs.stages);
  }
  std::vector<double*> numbers;
  if (word == "frame") numbers = {&costs.frame};
  if (word == "draw") numbers = {&costs.draw};
  if (word == "posed") numbers = {&costs.posed};
  for (const Rendering rendering : all_renderings) {
    RenderingCost& of = costs.of(rendering);
    if (word == to_text(rendering)) numbers = {&of.triangle, &of.vertex, &of.pixel};
  }
  if (numbers.size() != words.size()) return false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto number = number_in(words[i]);
    if (!number) return false;
    *numbers[i] = *number;
  }
  return true;
}

std::string found(const std::string& line) {
  std::string text = one_line(line.substr(0, 80));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) >= 127) c = '?';
  }
  return "but found '" + text + "'";
}

}  // namespace

RenderingCosts example_costs() {
  RenderingCosts costs;
  costs.machine = "built-in example, no real machine";
  costs.of(Rendering::full) = {0.5, 0.5, 1};
  costs.of(Rendering::without_normal_map) = {0.5, 0.4, 0.6};
  costs.of(Rendering::unlit) = {0.5, 0.3, 0.2};
  costs.frame = 200'000;
  costs.draw = 1'500;
  return costs;
}

double object_cost(const RenderingCosts& costs, const ObjectWork& work) {
  const RenderingCost& of = costs.of(work.rendering);
  const double vertex = work.posed > 0 ? of.vertex + costs.posed * (work.posed / work.vertices) : of.vertex;
  const foredraw_lod_rendering rendering = {static_cast<float>(of.triangle), static_cast<float>(vertex),
                                            static_cast<float>(of.pixel)};
  const auto put_together = costs.stages == Stages::sum ? foredraw_lod_sum : foredraw_lod_pipeline;
  return costs.draw * work.draws + put_together(&rendering, static_cast<float>(work.triangles),
                                                static_cast<float>(work.vertices), static_cast<float>(work.pixels));
}

double frame_cost(const RenderingCosts& costs, std::span<const ObjectWork> objects) {
  double cost = costs.frame;
  for (const ObjectWork& object : objects) cost += object_cost(costs, object);
  return cost;
}

std::string costs_text(const RenderingCosts& costs) {
  std::string text = "# What a machine takes to draw, in nanoseconds.\n";
  if (const std::string machine = one_line(costs.machine); !machine.empty()) text += "machine " + machine + '\n';
  text += "stages " + std::string(to_text(costs.stages)) + '\n';
  text += "frame " + number_text(costs.frame) + "  # each frame\n";
  text += "draw " + number_text(costs.draw) + "  # each draw call\n";
  text += "posed " + number_text(costs.posed) + "  # more for each vertex that joints or morph targets move\n";
  text += "# rendering, for each triangle, vertex and pixel\n";
  for (const Rendering rendering : all_renderings) {
    const RenderingCost& of = costs.of(rendering);
    text += std::string(to_text(rendering)) + ' ' + number_text(of.triangle) + ' ' + number_text(of.vertex) + ' ' +
            number_text(of.pixel) + '\n';
  }
  return text;
}

std::variant<RenderingCosts, std::string> costs_in(std::string_view text, const std::string& name) {
  if (text.size() > longest_text) return name + ": it is too long for a file of costs";
  RenderingCosts costs;
  std::map<std::string, int> lines;
  std::istringstream from{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(from, line); ++number) {
    const std::string place = name + ':' + std::to_string(number) + ": ";
    std::istringstream words(line.substr(0, line.find('#')));
    std::string word, rest;
    if (!(words >> word)) continue;
    std::getline(words, rest);
    const auto form = expected().find(word);
    if (form == expected().end()) {
      std::string all;
      for (const auto& [each, unused] : expected()) all += (all.empty() ? "" : ", ") + each;
      return place + "expected one of " + all + ", " + found(line);
    }
    const auto [first, is_new] = lines.emplace(word, number);
    if (!is_new) return place + "'" + word + "' is there already, in line " + std::to_string(first->second);
    if (!take(word, rest, costs)) {
      const bool takes_numbers = word != "machine" && word != "stages";
      return place + "expected '" + form->second + "'" + (takes_numbers ? " with numbers from 0 to 1e9" : "") + ", " +
             found(line);
    }
  }
  for (const auto& [word, form] : expected()) {
    if (word != "machine" && word != "posed" && !lines.contains(word)) return name + ": it has no line '" + form + "'";
  }
  return costs;
}

std::variant<RenderingCosts, std::string> read_costs(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(longest_text + 1, '\0');
  if (!file || (!file.read(text.data(), static_cast<std::streamsize>(text.size())) && !file.eof())) {
    return path + ": there is no such file, or it cannot be read; `foredraw calibrate` writes one";
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  return costs_in(text, path);
}

}  // namespace foredraw
