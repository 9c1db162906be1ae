"""How pages and their pictures look: on a screen, light and dark, and on paper."""

from __future__ import annotations

_LIGHT = """
--paper:#fff; --ink:#1c2128; --faint:#57606a; --line:#d0d7de; --panel:#f6f8fa;
--c0:#0969da; --c1:#cf222e; --c2:#1a7f37; --c3:#8250df; --c4:#9a6700; --good:#1a7f37;
--switch:#8250df; --miss:#cf222e; --alarm:#bc6c00; --fragment:#0969da; --kept:#9fb8d3;
--shade:#1c212840;
"""
_DARK = """
--paper:#12161c; --ink:#e3e8ee; --faint:#9aa5b1; --line:#343c47; --panel:#1a2029;
--c0:#6cb2ff; --c1:#ff7b72; --c2:#56d364; --c3:#c297ff; --c4:#e3b341; --good:#56d364;
--switch:#c297ff; --miss:#ff7b72; --alarm:#f0a94a; --fragment:#6cb2ff; --kept:#5b7a99;
--shade:#e3e8ee40;
"""

DRAWN = """
svg text{font:13px system-ui,sans-serif;fill:var(--ink)}
svg .small{font-size:11px}
svg .faint{fill:var(--faint)}
svg .title{font-weight:600}
svg .frame{fill:none;stroke:var(--faint)}
svg .grid{stroke:var(--line);fill:none}
svg .tick{stroke:var(--faint)}
svg .curve{fill:none;stroke-width:2;stroke-linejoin:round}
svg .c0{stroke:var(--c0)}
svg .c1{stroke:var(--c1);stroke-dasharray:7 4}
svg .c2{stroke:var(--c2);stroke-dasharray:2 3}
svg .c3{stroke:var(--c3);stroke-dasharray:10 3 2 3}
svg .c4{stroke:var(--c4);stroke-dasharray:14 4}
svg rect{shape-rendering:crispEdges}
svg .point{fill:var(--c1);stroke:var(--paper)}
"""
"""Curves are told apart by their dashes too, without colours."""

ALONE = f"svg{{background:var(--paper);{_LIGHT}}}{DRAWN}"
"""Of a picture that stands alone in a file: light wherever it is shown."""

PAGE = f"""
:root{{{_LIGHT}}}
@media screen and (prefers-color-scheme:dark){{:root{{{_DARK}}}}}
*{{box-sizing:border-box}}
body{{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 system-ui,sans-serif}}
main{{max-width:76rem;margin:0 auto;padding:1.5rem 1.25rem 4rem}}
h1{{font-size:1.65rem;line-height:1.25;margin:.4rem 0 .8rem;overflow-wrap:anywhere}}
h2{{font-size:1.25rem;margin:2.6rem 0 .6rem;padding-top:.6rem;border-top:1px solid var(--line)}}
h3{{font-size:1.05rem;margin:1.8rem 0 .4rem}}
h2,h3{{overflow-wrap:anywhere}}
p{{margin:.5rem 0;max-width:62rem}}
a{{color:var(--c0)}}
nav{{display:flex;flex-wrap:wrap;gap:.3rem 1.1rem}}
.note{{color:var(--faint)}}
.scrolled{{overflow-x:auto;margin:.8rem 0}}
table{{border-collapse:collapse;font-variant-numeric:tabular-nums}}
caption{{text-align:left;font-weight:600;padding:.2rem 0}}
th,td{{padding:.28rem .8rem;border-bottom:1px solid var(--line);text-align:right;
vertical-align:top;white-space:nowrap}}
thead th{{white-space:normal}}
th bdi,td bdi{{display:inline-block;white-space:normal;overflow-wrap:anywhere;min-width:7rem;
max-width:16rem}}
thead th{{border-bottom:2px solid var(--faint);vertical-align:bottom}}
th.word,td.word{{text-align:left}}
th:first-child,td:first-child{{padding-left:0}}
td.says{{text-align:left;color:var(--faint);min-width:22rem;white-space:normal}}
tr.group th{{text-align:left;padding-top:1rem;border-bottom:1px solid var(--faint)}}
tr.all td{{border-top:2px solid var(--faint);font-weight:600}}
.best{{font-weight:700;color:var(--good)}}
.best::before{{content:"★ "}}
.cards{{display:grid;grid-template-columns:repeat(auto-fit,minmax(8.5rem,1fr));gap:.7rem;
margin:1rem 0}}
.card{{background:var(--panel);border:1px solid var(--line);border-radius:8px;padding:.6rem .8rem}}
.card b{{display:block;font-size:1.5rem;line-height:1.25;font-variant-numeric:tabular-nums}}
.card span{{color:var(--faint)}}
.key{{display:flex;flex-wrap:wrap;gap:.2rem 1.3rem;margin:.4rem 0}}
.key svg{{width:1.1em;height:1.1em;min-width:0;vertical-align:-.15em;margin-right:.35em}}
.row{{display:flex;flex-wrap:wrap;gap:1rem 2rem;align-items:flex-start}}
.drawn{{overflow-x:auto;margin:.6rem 0}}
.row>.drawn{{flex:1 1 24rem}}
.drawn>svg{{display:block;width:100%;height:auto;min-width:44rem}}
.drawn.narrow>svg{{min-width:0}}
.pictures{{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,27rem),1fr));gap:1rem;
margin:.8rem 0}}
.pictures.little{{grid-template-columns:repeat(auto-fill,minmax(8.5rem,1fr));gap:.8rem}}
figure{{margin:0}}
figure .pair{{display:flex;gap:4px}}
figure .pair img{{width:calc(50% - 2px)}}
figure img{{display:block;width:100%;border-radius:4px;background:var(--panel)}}
figcaption{{font-size:13px;color:var(--faint);margin-top:.3rem}}
{DRAWN}
@media screen{{.scrolled,.drawn{{background:
linear-gradient(90deg,var(--paper) 60%,transparent) left/2rem 100% no-repeat local,
linear-gradient(270deg,var(--paper) 60%,transparent) right/2rem 100% no-repeat local,
linear-gradient(90deg,var(--shade),transparent) left/.7rem 100% no-repeat scroll,
linear-gradient(270deg,var(--shade),transparent) right/.7rem 100% no-repeat scroll}}}}
@media screen and (max-width:60rem){{.drawn:not(.narrow)>svg{{min-width:60rem}}}}
@media (max-width:40rem){{main{{padding:1rem .8rem 3rem}} td.says{{min-width:9.5rem}}
th,td{{padding:.28rem .5rem}} td.word,tr.group th{{white-space:normal}}
th bdi,td bdi{{min-width:4rem}}}}
@media print{{
@page{{margin:14mm}}
body{{font-size:10pt;background:#fff;color:#000}}
main{{max-width:none;padding:0}}
nav{{display:none}}
h2{{break-after:avoid}} h3,caption{{break-after:avoid}}
h2.sheet{{break-before:page;border-top:0}}
tr,figure,.card,.drawn{{break-inside:avoid}}
thead{{display:table-header-group}}
.scrolled,.drawn{{overflow:visible}}
.drawn>svg{{min-width:0;max-height:225mm}}
td.says{{min-width:0}}
th,td{{padding:.15rem .4rem}}
table{{font-size:8.5pt}}
.key,.note{{break-after:avoid}}
th bdi,td bdi{{min-width:0;max-width:11rem}}
.card,figure img{{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
svg{{print-color-adjust:exact;-webkit-print-color-adjust:exact}}
}}
"""
