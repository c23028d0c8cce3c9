// SPDX-License-Identifier: MIT
// The style of the report page: light or dark as the reader's system is, and light on paper.
#include <string_view>

namespace lichen {

extern const std::string_view kPageStyle = R"(
:root {
  --page: #faf9f6; --card: #fff; --text: #23282b; --quiet: #626b6f; --line: #dedcd5;
  --accent: #1f6f63; --exemplar: #b9c2c4;
  --good: #1f6f4a; --warn: #8a5a00; --bad: #a8361a;
}
@media screen and (prefers-color-scheme: dark) {
  :root {
    --page: #14181a; --card: #1c2124; --text: #e1e5e4; --quiet: #98a3a5; --line: #30383b;
    --accent: #79cbb8; --exemplar: #4d595d;
    --good: #7fcf9f; --warn: #e3b564; --bad: #f2957a;
  }
}
* { box-sizing: border-box; print-color-adjust: exact; }
body {
  max-width: 1180px; margin: 0 auto; padding: 16px 24px;
  background: var(--page); color: var(--text); font: 16px/1.5 system-ui, sans-serif;
  overflow-wrap: anywhere;
}
header p { margin: 4px 0; font-size: 1.1rem; }
h1 { margin: 0 0 8px; font-size: 2rem; line-height: 1.2; }
h2 { margin: 0; font-size: 1.35rem; }
h3 { margin: 28px 0 8px; font-size: 1.05rem; break-after: avoid; }
article, footer { margin-top: 40px; padding-top: 24px; border-top: 1px solid var(--line); }
pre {
  padding: 10px 14px; background: var(--card); border: 1px solid var(--line); border-radius: 6px;
  font: 0.875rem/1.5 ui-monospace, monospace; white-space: pre-wrap;
}
.good { color: var(--good); }
.warn { color: var(--warn); }
.bad { color: var(--bad); }
.quiet, .detail, summary, dt { color: var(--quiet); }
.detail { display: block; font-size: 0.875rem; font-weight: 400; }
p.quiet { margin: 2px 0 8px; }
b { color: var(--text); font-weight: 600; }

/* Pictures have widths as shares of the page's. */
.panes {
  display: flex; flex-wrap: wrap; align-items: start; gap: 14px 1%; margin-top: 16px;
  container-type: inline-size;
}
details { width: min-content; min-width: min(100%, 132px); break-inside: avoid; }
summary { display: block; cursor: zoom-in; font-size: 0.9375rem; line-height: 1.4; }
summary::-webkit-details-marker { display: none; }
[open] > summary { cursor: zoom-out; }
summary img, .repeated {
  display: block; width: calc(92cqw * var(--small)); height: auto; margin-bottom: 6px;
  border-radius: 4px;
}
[open] img, [open] .repeated { width: calc(100cqw * var(--large)); }
summary :is(img, .repeated) + img { margin: 0 auto 6px; }
.caption { display: block; }

table { width: 100%; border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: 8px 14px 8px 0; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
tr { break-inside: avoid; }
tr.quiet th { font-size: 0.875rem; font-weight: 400; }
.number { text-align: right; }
td { white-space: nowrap; }
.risks { margin: 0; padding: 0; list-style: none; }
.risks li { padding: 8px 0; border-bottom: 1px solid var(--line); }
.risks b::first-letter { text-transform: uppercase; }

.key { display: inline-block; width: 18px; height: 10px; background: var(--exemplar); }
.key.result { height: 2px; margin-bottom: 4px; background: var(--accent); }
.key.gaussian { height: 0; margin-bottom: 4px; background: none; border-top: 2px dashed var(--warn); }
.histograms { display: grid; grid-template-columns: repeat(auto-fit, minmax(240px, 1fr)); gap: 18px; }
figure { max-width: 420px; margin: 0; }
svg { display: block; width: 100%; max-width: 760px; break-inside: avoid; }
svg text { fill: var(--quiet); font: 12px system-ui, sans-serif; }
svg line { stroke: var(--line); }
path { fill: none; stroke: var(--accent); stroke-width: 1.75; stroke-linejoin: round; }
path.area { fill: var(--exemplar); stroke: none; }
path.exemplar { stroke: var(--exemplar); stroke-width: 5; }
path.gaussian { stroke: var(--warn); stroke-dasharray: 5 4; }

footer { display: grid; grid-template-columns: repeat(auto-fit, minmax(260px, 1fr)); gap: 24px 40px; }
dl { display: grid; grid-template-columns: fit-content(60%) minmax(0, 1fr); gap: 4px 18px; margin: 10px 0 0; }
dd { margin: 0; font-variant-numeric: tabular-nums; }
footer ul { margin: 10px 0 0; padding-left: 1.2em; }

@media (max-width: 700px) {
  body { padding: 8px 16px; }
  summary img, .repeated { width: calc(92cqw * min(1, 2.5 * var(--small))); }
}
)";

} // namespace lichen
