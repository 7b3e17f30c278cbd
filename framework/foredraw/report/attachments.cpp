// What the record of a run tells of films and charts.
#include <foredraw/report/attachment_json.h>
#include <foredraw/report/private/report_json.h>

namespace foredraw {

namespace {

void add_members(Json& json, const Film& film) {
  json["width"] = film.width;
  json["height"] = film.height;
  json["frames"] = film.frames.size();
}

void add_members(Json& json, const Chart& chart) {
  json["x"] = chart.x;
  json["y"] = chart.y;
  json["unit"] = chart.unit;
  if (chart.mark) json["mark"] = JsonObject{{"name", chart.mark->name}, {"value", json_of(chart.mark->value)}};
  json["lines"] = Json::array();
  for (const Chart::Line& line : chart.lines) {
    Json values = Json::array();
    for (const double value : line.values) values.push_back(json_of(value));
    json["lines"].push_back(JsonObject{{"name", line.name}, {"values", std::move(values)}});
  }
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

Json json_of(const AttachmentRecord& attachment) {
  const Attachment& content = *attachment.content;
  Json json =
      JsonObject{{"kind", std::holds_alternative<Film>(content) ? "film" : "chart"}, {"place", attachment.about}};
  std::visit(
      [&](const auto& shown) {
        json["name"] = shown.name;
        json["caption"] = shown.caption;
        add_members(json, shown);
      },
      content);
  return json;
}

std::string to_json(const AttachmentRecord& attachment) { return indented_text(json_of(attachment)); }

void leave_out_pictures(Report& report) {
  for (std::vector<StageRecord>* records : {&report.stages, &report.measures}) {
    for (StageRecord& record : *records) {
      leave_out_pictures(record.attachments);
      leave_out_pictures(record.attachments_before);
    }
  }
}

}  // namespace foredraw
