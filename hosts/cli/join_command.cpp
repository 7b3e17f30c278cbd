// The reports of the parts of a folder, put together.

#include "session.h"
#include "text_outputs.h"

#include <foredraw/report/batch_join.h>
#include <foredraw/report/since.h>

#include <fmt/format.h>

namespace foredraw::cli {

Exit join_reports(const JoinArguments& arguments, const Registry& registry) {
  Diagnostics diagnostics;
  if (!have_files_of_their_own(files_read(arguments), {}, arguments, diagnostics)) return refuse(diagnostics);
  if (!have_folders({arguments.report}, diagnostics)) return refuse_file(diagnostics);
  const auto baseline = baseline_of(arguments.baseline, diagnostics);
  if (diagnostics.has_errors()) return refuse(diagnostics);
  Spool spool(spool_folder(arguments.report));
  BatchJoin join(spool);
  for (const std::string& part : arguments.inputs) {
    const auto bytes = read_file(part, diagnostics);
    if (!bytes) return refuse_file(diagnostics);
    const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    if (!join.add(text, part, diagnostics)) return refuse(diagnostics);
  }
  const bool is_whole = join.is_whole(diagnostics);
  Exit worst = is_whole ? done : something_failed;
  tell(diagnostics);
  std::optional<Since> since;
  if (baseline) since.emplace(arguments.baseline, *baseline, !is_whole);
  Batch batch(join.command(), registry, spool, [&](const StoredReport& report, Outcome outcome) {
    if (since) since->add(report, outcome);
  });
  join.put_into(batch);
  if (!batch.is_done()) worst = something_failed;  // as one process would end
  const auto write = [&](const OutputFile::Put& put) {
    batch.write_json(join.seconds(), std::nullopt, put, since ? since->to_json() : "");
  };
  if (!arguments.report.empty()) {
    const OutputFile report{arguments.report, {}, write};
    Diagnostics writing;
    if (!write_files(std::span(&report, 1), writing)) return refuse_file(writing);
  }
  if (!arguments.json)
    return std::max(worst, print(batch.to_text(join.seconds()) + (since ? '\n' + since->to_text() : "")));
  return std::max(worst, print_pieces(write));
}

}  // namespace foredraw::cli
