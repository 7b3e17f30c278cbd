// What this machine takes to draw, measured and written as a file.

#include "session.h"

#include <foredraw/frames/calibration.h>
#include <foredraw/frames/reference_machine.h>
#include <foredraw/platform/machine.h>

#include <fmt/format.h>

namespace foredraw::cli {

namespace {

std::string percent(double part) { return fmt::format("{:.1f} %", 100 * part); }

std::string error_text(Stages stages, const FitError& error) {
  return fmt::format("stages {}: off by {} in the mean, {} at most", to_text(stages), percent(error.mean),
                     percent(error.most));
}

}  // namespace

Exit calibrate(const CalibrateArguments& arguments, const Registry&) {
  Diagnostics diagnostics;
  if (!have_folders({arguments.costs}, diagnostics)) return refuse_file(diagnostics);
  CalibrationOptions options;
  options.rounds = arguments.rounds;
  if (const auto line = progress_line()) options.progress = [line](double done) { line("calibrate", done); };
  Calibration found = foredraw::calibrate(reference_machine(), options);
  end_progress();
  found.costs.machine = "reference renderer, one thread, " + machine_text();
  const std::string told = fmt::format("Fitted to half of {} frames, the costs predict the other half:", found.frames);
  std::string text = costs_text(found.costs);
  for (const std::string& line :
       {told, error_text(Stages::max, found.max_error), error_text(Stages::sum, found.sum_error),
        std::string("The costs are those of the better one, fitted to all frames.")}) {
    text += "# " + line + '\n';
  }
  if (arguments.costs.empty()) return print(text);
  const OutputFile files[] = {text_file(arguments.costs, text)};
  return write_files(files, diagnostics) ? print(text) : refuse_file(diagnostics);
}

}  // namespace foredraw::cli
