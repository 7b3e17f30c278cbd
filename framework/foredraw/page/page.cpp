#include <foredraw/page/page.h>

#include <foredraw/page/private/html.h>
#include <foredraw/page/private/page_assets.h>
#include <foredraw/page/private/page_files.h>
#include <foredraw/page/private/page_sections.h>
#include <foredraw/page/private/shown_attachments.h>
#include <foredraw/wires/wire_shader.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace foredraw {

namespace {

constexpr std::string_view without_script =
    "This program was built without npm, so that the page has no plot, no viewer and no sorting. Build it where npm is "
    "installed and its registry can be reached.";
constexpr std::string_view script_is_off = "This part is made by the page's script, which has not run.";

struct Section {
  std::string id;
  std::string title;
  std::string content;
};

std::string with_script() {
  return element("p", page_script().empty() ? without_script : script_is_off, "class=\"without-script\"");
}

/// Of more files than `most` the first ones alone are shown.
std::string left_out(std::size_t files, std::size_t most, std::size_t displays) {
  if (files <= most) return "";
  return '\n' +
         element("p", fmt::format("Of {} files the first {} are shown here.", files, displays), "class=\"note\"");
}

std::string json_data(std::string_view id, std::string_view json) {
  return element("script", json, fmt::format("type=\"application/json\" id=\"{}\"", id)) + '\n';
}

/// In elements of one class: a browser takes twice as long to read one long text.
std::string buffer_data(const Display& display) {
  constexpr std::size_t piece = 60000;  // below the 65,536 characters of a text node in Chromium; whole groups of four
  std::string text;
  for (std::size_t at = 0; at < display.buffer.size(); at += piece) {
    text += element("script", std::string_view(display.buffer).substr(at, piece),
                    fmt::format("type=\"application/octet-stream\" class=\"{}\"", display.buffer_name)) +
            '\n';
  }
  return text;
}

std::string attachment_data(const ShownAttachments& attachments) {
  if (attachments.json.empty()) return "";
  std::string text = json_data("attachments", script_safe(attachments.json));
  for (std::size_t i = 0; i < attachments.pictures.size(); ++i) {
    text += element("script", attachments.pictures[i],
                    fmt::format("type=\"application/octet-stream\" id=\"picture-{}\"", i)) +
            '\n';
  }
  return text;
}

/// The JSON form without the spaces that are for people.
std::string compact_json(std::span<const Comparison> comparisons, const Comparison* all) {
  return nlohmann::ordered_json::parse(to_json(comparisons, {}, all)).dump();
}

std::string scripts(std::span<const Comparison> comparisons, const Comparison* all, std::span<const Display> displays,
                    const ShownAttachments& attachments) {
  std::string text = json_data("comparison", script_safe(compact_json(comparisons, all)));
  if (page_script().empty()) return text;
  std::string scenes;
  for (const Display& display : displays) scenes += (scenes.empty() ? "" : ",") + display.scene;
  text += json_data("scenes", script_safe("{\"scenes\":[" + scenes + "]}"));
  for (const Display& display : displays) text += buffer_data(display);
  text += attachment_data(attachments);
  if (std::ranges::any_of(displays, &Display::has_wires)) {
    text += element("script", wire_functions_text(), "type=\"text/plain\" id=\"wire-functions\"") + '\n';
  }
  return text + element("script", page_script()) + '\n';
}

}  // namespace

std::string page(std::span<const Comparison> comparisons, std::span<const Display> displays,
                 const std::string& program) {
  const auto sum = sum_of(comparisons);
  const Comparison* all = sum ? &*sum : nullptr;
  const bool are_many = comparisons.size() > most_articles;
  const auto alone = are_many ? comparisons.first(most_displays) : comparisons;
  const ShownAttachments attachments = shown_attachments(alone);
  const std::string more = left_out(comparisons.size(), alone.size(), alone.size());
  const auto first_files = [&](std::size_t count) { return left_out(comparisons.size(), most_displays, count); };
  const std::string frames = attachments.json.empty() ? "" : with_script() + first_files(most_displays);
  const Section sections[] = {{"summary", "Summary", summary_html(are_many ? alone.first(0) : alone, all)},
                              {"files", "Files", are_many ? with_script() : ""},
                              {"figures", "Figures", figures_html(are_many ? alone.first(0) : alone, all)},
                              {"plot", "Two figures against each other", with_script()},
                              {"frames", "Frames", frames},
                              {"viewer", "3D view", with_script() + first_files(displays.size())},
                              {"draws", "Draws", draws_html(alone) + more},
                              {"stages", "Stages", stages_html(alone) + more},
                              {"diagnostics", "Diagnostics", diagnostics_html(comparisons, most_articles)},
                              {"pipelines", "Pipelines", pipelines_html(comparisons)},
                              {"run", "The run", run_html(comparisons, program)}};
  std::string links, body;
  for (const Section& section : sections) {
    if (section.content.empty()) continue;
    links += element("a", escaped(section.title), fmt::format("href=\"#{}\"", section.id)) + '\n';
    body += element("section", '\n' + element("h2", escaped(section.title)) + '\n' + section.content + '\n',
                    fmt::format("id=\"{}\"", section.id)) +
            '\n';
  }
  const std::string title =
      comparisons.size() == 1 ? comparisons[0].input.path : fmt::format("{} files", comparisons.size());
  return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         // Nothing is fetched, whatever a name in a file may try.
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
         "style-src 'unsafe-inline'; img-src data: blob:\">\n" +
         element("title", escaped(title + ", by Foredraw")) + '\n' + element("style", page_style()) +
         "\n</head>\n<body>\n" +
         element("header", element("h1", "Foredraw") + element("p", escaped(title), "class=\"lead\"")) + '\n' +
         element("nav", '\n' + links, "aria-label=\"Sections\"") + '\n' + element("main", '\n' + body) + '\n' +
         (are_many ? json_data("file-figures", script_safe(file_figures(comparisons))) : "") +
         scripts(alone, all, displays, attachments) + "</body>\n</html>\n";
}

}  // namespace foredraw
