// SPDX-License-Identifier: MIT
// Counts crossings, and links against the reading direction, in drawings of `grafverif draw` and in the layered layout
// that ELK computes for the same graph: node crossings.mjs FOLDER_OF_ELKJS FILE.svg...  (npm install elkjs)
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename } from 'node:path';

const [folder, ...files] = process.argv.slice(2);
const ELK = createRequire(folder + '/')('elkjs');

function drawn(svg) {
  const nodes = new Map(), links = [];
  for (const [, attributes, body] of svg.matchAll(/<g ([^>]*)>(.*?)<\/g>/gs)) {
    const attribute = (name) => (attributes.match(new RegExp(`${name}="([^"]*)"`)) ?? [])[1];
    const kind = attribute('class').split(' ')[0];
    const lines = [...body.matchAll(/points="([^"]*)"/g)].map(([, points]) =>
      points.split(' ').map((point) => point.split(',').map(Number)));
    if (kind === 'step') nodes.set(attribute('id'), { width: 40, height: 40 });
    if (kind === 'transition') nodes.set(attribute('id'), { width: 30, height: 4 });
    if (kind === 'link') links.push({ from: attribute('data-from'), to: attribute('data-to'), lines });
  }
  return { nodes, links };
}

async function laidOut({ nodes, links }) {
  const graph = await new ELK().layout({
    id: 'root',
    layoutOptions: { 'elk.algorithm': 'layered', 'elk.direction': 'DOWN', 'elk.edgeRouting': 'ORTHOGONAL' },
    children: [...nodes].map(([id, size]) => ({ id, ...size })),
    edges: links.map(({ from, to }, k) => ({ id: `e${k}`, sources: [from], targets: [to] })),
  });
  return graph.edges.map(({ sources, targets, sections }) => ({
    from: sources[0], to: targets[0],
    lines: sections.map(({ startPoint, bendPoints = [], endPoint }) =>
      [startPoint, ...bendPoints, endPoint].map(({ x, y }) => [x, y])),
  }));
}

// Returns the number of points at which a horizontal and a vertical line cross in the interior of both lines.
function crossings(links) {
  const across = [], along = [], places = new Set();
  for (const { lines } of links)
    for (const line of lines)
      for (let k = 1; k < line.length; ++k) {
        const [[x1, y1], [x2, y2]] = [line[k - 1], line[k]];
        if (y1 === y2) across.push([Math.min(x1, x2), Math.max(x1, x2), y1]);
        else along.push([Math.min(y1, y2), Math.max(y1, y2), x1]);
      }
  for (const [left, right, y] of across)
    for (const [top, bottom, x] of along)
      if (left + 0.5 < x && x < right - 0.5 && top + 0.5 < y && y < bottom - 0.5) places.add(`${x} ${y}`);
  return places.size;
}

const upward = (links) => links.filter(({ lines }) =>
  lines.some((line) => line.some(([, y], k) => k > 0 && y < line[k - 1][1]))).length;

console.log('| drawing | nodes | links | crossings | ELK | upward links | ELK |\n| --- | --- | --- | --- | --- | --- | --- |');
for (const file of files) {
  const ours = drawn(readFileSync(file, 'utf8')), theirs = await laidOut(ours);
  console.log(`| ${basename(file, '.svg')} | ${ours.nodes.size} | ${ours.links.length} | ${crossings(ours.links)} | ` +
    `${crossings(theirs)} | ${upward(ours.links)} | ${upward(theirs)} |`);
}
