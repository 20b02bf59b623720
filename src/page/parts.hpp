// SPDX-License-Identifier: MIT
// The sections of a page.
#pragma once

#include "page/html.hpp"
#include "page/page.hpp"

namespace grafverif {

/// File, version, date, the summary verdict, assumptions, warnings.
void add_head(const PageContent& content, Html& html);
/// Every property; those that hold as expected are folded.
void add_verdicts(const PageContent& content, Html& html);
/// The element of the player; without a script, the runs as text.
void add_runs(const PageContent& content, Html& html);
void add_findings(const PageContent& content, Html& html);
void add_charts(const PageContent& content, Html& html);
void add_plant(const PageContent& content, Html& html);
void add_equations(const PageContent& content, Html& html);
/// The steps and transitions that the runs of the page used.
void add_coverage(const PageContent& content, Html& html);

}  // namespace grafverif
