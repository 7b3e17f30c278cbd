#pragma once
// What evaluators of overdraw share: a plugin says how triangles are drawn and counted, as an OverdrawService;
// subjects, views, figures and what is told about them are the same for all.

#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/measuring/pose_options.h>
#include <foredraw/measuring/view_options.h>
#include <foredraw/technique/plugin.h>
#include <foredraw/technique/subject_options.h>
#include <foredraw/viewing/drawn_orders.h>

#include <concepts>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace foredraw {

/// Looks from Fibonacci points by default, since orders are commonly optimised for an icosphere, and in poses between
/// the keys for which they are made.
struct OverdrawOptions : ViewSet, PoseSet {
  OverdrawOptions() {
    views = "fibonacci";
    size = 256;
    poses = "16";
  }
  Faces faces = Faces::material;
  SubjectUnit subject = SubjectUnit::character;
  SequenceFrom sequence = SequenceFrom::table;
  bool details = false;
  std::optional<double> error;  ///< wanted of every subject's ratio: views and size are then picked to reach it
};

template <class Options>
requires std::derived_from<Options, OverdrawOptions>
void add_faces_row(OptionTable<Options>& table) {
  table.template choice<Faces>(
      &OverdrawOptions::faces, "faces",
      "Which faces are drawn: as the material culls, or only front faces, as in published figures",
      {{"material", Faces::material}, {"front", Faces::front}});
}

/// What every evaluator of overdraw measures.
std::vector<Metric> overdraw_metrics();

template <class Options>
requires std::derived_from<Options, OverdrawOptions>
void add_evaluator_rows(OptionTable<Options>& table) {
  table.template choice<SequenceFrom>(
      &OverdrawOptions::sequence, "sequence",
      "In which sequence draws are drawn. table: as tables of orders say, else as in the file; file: as in the file, "
      "whatever tables say; material: by the material's number, much as engines do that sort",
      {{"table", SequenceFrom::table}, {"file", SequenceFrom::file}, {"material", SequenceFrom::material}});
  table.template row<bool>(
      &OverdrawOptions::details, "details",
      "Report how many pixels are shaded how often, and which draws and clusters cause the overdraw");
  table.template row<std::optional<double>>(&OverdrawOptions::error, "error",
                                            "Choose views and size so that the error of each subject's ratio is at "
                                            "most this, 19 times out of 20; views, count and size are then ignored",
                                            {1e-4, 1, "fragments per pixel"});
}

/// Draws every subject of a scene through the service. std::invalid_argument where the views or poses have a mistake.
std::unique_ptr<Evaluator> overdraw_evaluator(std::unique_ptr<OverdrawService> service, const OverdrawOptions& options);

/// The options of an evaluator that overdraw_evaluator() made; nullptr: the technique is another one.
const OverdrawOptions* overdraw_options_of(const Technique& technique);

/// An evaluator and a service in one. `add_rows(table)` adds the rows of what Options has besides; `make(options)`
/// makes the service. The card's metrics are joined to those that all evaluators of overdraw have.
template <class Options, class AddRows, class Make>
requires std::derived_from<Options, OverdrawOptions> Plugin overdraw_plugin(Card card, AddRows add_rows, Make make) {
  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = std::move(card);
  plugin.card.acts_on = {traits::triangles};
  const std::vector<Metric> metrics = overdraw_metrics();
  plugin.card.metrics.insert(plugin.card.metrics.begin(), metrics.begin(), metrics.end());

  OptionTable<Options> table;
  add_view_rows(table);
  add_pose_rows(table);
  add_faces_row(table);
  add_subject_row<Options>(table, &OverdrawOptions::subject);
  add_evaluator_rows(table);
  add_rows(table);
  bind_options(plugin, std::move(table),
               [make](const Options& options) { return overdraw_evaluator(make(options), options); });

  OptionTable<Options> service_table;
  add_faces_row(service_table);
  add_rows(service_table);
  plugin.service_options = service_table.specs();
  plugin.overdraw_service = [service_table, make](const Settings& settings) {
    return make(service_table.read(settings));
  };
  return plugin;
}

}  // namespace foredraw
