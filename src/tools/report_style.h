// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace line_plane_segmentation {

/// How the report looks, light or dark as the reader's system is.
constexpr char kReportStyle[] = R"css(
:root { color-scheme: light dark; --text: #222; --soft: #667; --line: #ccd; --back: #fff; --card: #f6f7f9; }
@media (prefers-color-scheme: dark) {
  :root { --text: #dde; --soft: #99a; --line: #445; --back: #181b20; --card: #22262d; }
}
body { font: 15px/1.45 system-ui, sans-serif; color: var(--text); background: var(--back); max-width: 1180px;
  margin: 24px auto; padding: 0 20px; }
h1 { font-size: 24px; margin: 0 0 4px; }
h2 { font-size: 17px; margin: 0 0 10px; width: 100%; overflow-wrap: anywhere; }
.tiles { display: flex; flex-wrap: wrap; gap: 12px; margin: 16px 0 24px; }
.tile { background: var(--card); border-radius: 8px; padding: 10px 18px; color: var(--soft); }
.tile b { display: block; font-size: 22px; color: var(--text); }
.plot { display: block; width: 100%; }
.plot text { font: 12px system-ui, sans-serif; fill: var(--soft); }
.plot .tick { text-anchor: end; }
.plot .title { fill: var(--text); }
.plot .grid { stroke: var(--line); }
.plot a:hover rect { opacity: 0.6; }
.legend span { margin-right: 18px; white-space: nowrap; }
i { display: inline-block; width: 12px; height: 12px; border-radius: 3px; margin-right: 6px; vertical-align: -1px; }
article { display: flex; flex-wrap: wrap; gap: 0 24px; align-items: flex-start; border-top: 1px solid var(--line);
  padding: 18px 0; content-visibility: auto; contain-intrinsic-size: auto 460px; }
article:target h2 { color: #d62; }
article img { flex: 1 1 440px; min-width: 0; max-width: 560px; height: auto; border-radius: 6px; }
article div { flex: 1 1 480px; min-width: 0; overflow-x: auto; }
table { border-collapse: collapse; margin-bottom: 12px; font-variant-numeric: tabular-nums; width: 100%; }
th { font-weight: 500; color: var(--soft); }
th, td { text-align: right; padding: 2px 8px; white-space: nowrap; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
.bar { display: block; width: 100%; height: 10px; }
)css";

}  // namespace line_plane_segmentation
