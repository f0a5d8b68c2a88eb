"""Pictures of what a flat program moves: SVG (svg.py), a page with an interactive view (page.py), columns for editors' views (columns.py).

`viewer.js` beside this file is the view itself; vscode-extension/scripts/viewer.mjs makes it from vscode-extension/viewer. Opens no file.
"""
