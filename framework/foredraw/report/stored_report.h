#pragma once
// What a table and a sum need of a report, out of its JSON form: so a report that was stored and one that was just made
// give the same.

#include <foredraw/report/report.h>
#include <foredraw/technique/registry.h>

#include <string_view>

namespace foredraw {

struct StoredReport {
  FileRecord input;
  FileRecord output;
  bool optimized = false;
  StateRecord before;
  StateRecord after;
  std::vector<Diagnostic> diagnostics;
};

/// Which way a figure is better, and what becomes of it in a sum, say the cards of the registry's plugins. Throws
/// std::invalid_argument where the text is no report.
StoredReport stored_report(std::string_view json, const Registry& registry);

}  // namespace foredraw
