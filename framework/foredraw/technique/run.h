#pragma once
// All that a technique may ask of its surroundings. There are no globals.

#include <foredraw/analysis/analyses.h>
#include <foredraw/base/parallel.h>
#include <foredraw/scene/draw.h>
#include <foredraw/scene/lender.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/product_row.h>
#include <foredraw/scene/subject.h>
#include <foredraw/scene/views.h>
#include <foredraw/technique/attachment.h>
#include <foredraw/technique/options.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace foredraw {

class OverdrawService;

/// What a figure or a note is about: a draw, a subject (by its number among subjects_of(scene, run.subjects)), or, with
/// neither, the scene. A figure of the scene stands in place of the sum over its parts.
struct About {
  std::optional<DrawId> draw;
  std::optional<std::uint32_t> subject;
  std::size_t level = 0;  ///< of a draw or subject; figures of coarser levels are in no sum
  friend bool operator==(const About&, const About&) = default;
};

/// A measured figure: numerator / denominator, and over several of these sum / sum. A count has no denominator: over
/// several it is the sum.
struct Measured {
  std::string metric;  ///< as on the card: "acmr", or under a group: "models.fifo-32.acmr"
  double numerator = 0;
  std::optional<double> denominator;
  double error = 0;  ///< of the figure: one standard deviation; 0: exact
  About about;
};

struct Note {
  std::string code;
  std::string message;
  About about;
};

/// Pictures or curves. They are shared, not copied: what runs have alike is held once.
struct Attached {
  std::shared_ptr<const Attachment> content;
  About about;
};

/// What one call of a technique found out. Each call has its own, so nothing needs a lock and the order never depends
/// on the threads.
struct Findings {
  std::vector<Measured> measured;
  std::vector<Note> notes;
  std::vector<Attached> attached;
  std::optional<std::string> nothing_to_gain;  ///< why what there is stays
};

inline const ProductRows no_products;

struct Run {
  Analyses& analyses;
  const Executor& executor;
  Findings& findings;
  const Views& views;                         ///< what orders are optimised for: the pipeline's [views]
  const Poses& poses = rest_pose;             ///< and in which poses: the pipeline's [poses]
  const OverdrawService* overdraw = nullptr;  ///< who answers for measured overdraw, where the card asks for it
  std::uint64_t seed = 0;                     ///< from the pipeline's seed, the stage and what it is about
  About about;                                ///< what figures and notes are about unless they say otherwise
  const std::atomic<bool>* cancel = nullptr;
  std::function<void(double)> progress = {};      ///< may be empty; the part done, 0 to 1; from any thread
  const Loans& loans = no_loans;                  ///< what the stage's options name, as the host read it
  SubjectUnit subjects = SubjectUnit::character;  ///< what is seen as one: the pipeline's [subjects]
  /// For evaluators: the scene that the run began with, before any stage and with all its levels. What changes geometry
  /// is measured against it. Draws keep their numbers; stages add theirs behind. Null for those that change a scene:
  /// what they answer hangs on what they are given alone.
  const Scene* original = nullptr;
  const ProductRows& products = no_products;  ///< rows of all that the scene may hold

  /// For processors that order triangles: where ranges begin that other products than `own` count on. What orders
  /// leaves every triangle in its range, or takes it out of the ranges of which it knows that they may lose it.
  /// Orderers and clusterers need not ask: each range is handed to them as a draw.
  std::vector<std::uint32_t> bounds(const Scene& of, DrawLevel at, std::string_view own) const {
    return bounds_of(of, at, products, own);
  }

  /// What an option names. std::invalid_argument where it names nothing, or nothing that was lent: a plan that exists
  /// has lent all that its options name.
  const Scene& scene(const ScenePath& named) const;
  const Image& image(const ImagePath& named) const;

  void measure(std::string metric, double numerator, double denominator, double error = 0) const {
    measure_at(about, std::move(metric), numerator, denominator, error);
  }
  void measure_at(About where, std::string metric, double numerator, double denominator, double error = 0) const {
    findings.measured.push_back({std::move(metric), numerator, denominator, error, where});
  }
  void count(std::string metric, double number) const { count_at(about, std::move(metric), number); }
  void count_at(About where, std::string metric, double number) const {
    findings.measured.push_back({std::move(metric), number, std::nullopt, 0, where});
  }
  void note(std::string code, std::string message) const { note_at(about, std::move(code), std::move(message)); }
  void note_at(About where, std::string code, std::string message) const {
    findings.notes.push_back({std::move(code), std::move(message), where});
  }
  /// Shows pictures or curves beside the figures. Throws std::invalid_argument where mistake_in() finds one, or where
  /// this call has attached something of that name to the same draw, subject or scene.
  void attach(Attachment attachment) const { attach_at(about, std::move(attachment)); }
  void attach_at(About where, Attachment attachment) const;
  /// Says that nothing can be gained here, and why, with the figure: what there is stays, whatever the technique
  /// answers, and counts as what the card provides.
  void keep(std::string reason) const { findings.nothing_to_gain = std::move(reason); }
  bool keeps() const { return findings.nothing_to_gain.has_value(); }
  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
};

}  // namespace foredraw
