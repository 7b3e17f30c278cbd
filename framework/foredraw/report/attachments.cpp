// What the record of a run tells of films and charts.
#include <foredraw/report/private/attachment_json.h>
#include <foredraw/report/private/report_json.h>

namespace foredraw {

namespace {

void write(JsonWriter& out, const Film& film) {
  out.key("width").value(film.width);
  out.key("height").value(film.height);
  out.key("frames").value(film.frames.size());
}

void write(JsonWriter& out, const Chart& chart) {
  out.key("x").value(chart.x);
  out.key("y").value(chart.y);
  out.key("unit").value(chart.unit);
  if (chart.mark) {
    out.key("mark").begin('{');
    out.key("name").value(chart.mark->name);
    out.key("value").value(chart.mark->value);
    out.end('}');
  }
  out.key("lines").begin('[');
  for (const Chart::Line& line : chart.lines) {
    out.begin('{');
    out.key("name").value(line.name);
    out.key("values").begin('[');
    for (const double value : line.values) out.value(value);
    out.end(']');
    out.end('}');
  }
  out.end(']');
}

void leave_out_pictures(std::vector<AttachmentRecord>& attachments) {
  for (AttachmentRecord& attachment : attachments) {
    const Film* film = std::get_if<Film>(attachment.content.get());
    if (film == nullptr) continue;
    Film bare{film->name, film->caption, film->width, film->height, {}};
    bare.frames.resize(film->frames.size());
    attachment.content = std::make_shared<const Attachment>(std::move(bare));
  }
}

}  // namespace

void write(JsonWriter& out, const AttachmentRecord& attachment) {
  const Attachment& content = *attachment.content;
  out.begin('{');
  out.key("kind").value(std::holds_alternative<Film>(content) ? "film" : "chart");
  out.key("place").value(attachment.about);
  std::visit(
      [&](const auto& shown) {
        out.key("name").value(shown.name);
        out.key("caption").value(shown.caption);
        write(out, shown);
      },
      content);
  out.end('}');
}

Json json_of(const AttachmentRecord& attachment) {
  return Json::parse(json_text([&](JsonWriter& out) { write(out, attachment); }));
}

void leave_out_pictures(Report& report) {
  for (std::vector<StageRecord>* records : {&report.stages, &report.measures}) {
    for (StageRecord& record : *records) {
      leave_out_pictures(record.attachments);
      leave_out_pictures(record.attachments_before);
    }
  }
}

}  // namespace foredraw
