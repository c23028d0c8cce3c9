// SPDX-License-Identifier: MIT
// Fills the page from its data: texts, the three pictures with their common view, charts.
'use strict';

const report = JSON.parse(document.getElementById('data').textContent);

/// A number as people read it: three significant digits.
function shown(value, unit) {
  return Number(value.toPrecision(3)) + (unit ? ' ' + unit : '');
}

function element(name, text, className) {
  const made = document.createElement(name);
  made.textContent = text;
  if (className)
    made.className = className;
  return made;
}

async function loaded(picture) {
  const image = new Image();
  image.src = picture.png;
  await image.decode();
  return image;
}

// ---- the pictures ------------------------------------------------------------------------------

/// One view of all panes of a map, in pixels of the exemplar's picture: its centre, and how many
/// CSS pixels one of them spans. The exemplar lies in the middle of what repeats.
class Viewer {
  /// Of the pictures, `original` and `gaussian` may be null.
  constructor(root, {original, exemplar, gaussian, result}) {
    this.root = root;
    this.original = original;
    this.exemplar = exemplar;
    this.gaussian = gaussian;
    this.result = result;
    const aspect = Math.min(2, Math.max(0.75, result.width / result.height));
    root.style.setProperty('--aspect', aspect);
    this.canvases = [...root.querySelectorAll('figure:not([hidden]) canvas')];
    for (const canvas of this.canvases)
      this.listen(canvas);
    for (const button of root.querySelectorAll('button'))
      button.addEventListener('click', () => this.zoomTo(button.dataset.zoom));
    const resized = new ResizeObserver(() => this.fitted ? this.fit() : this.draw());
    this.canvases.forEach((canvas) => resized.observe(canvas));
    const scheme = matchMedia('(prefers-color-scheme: dark)');
    scheme.addEventListener('change', () => this.draw());
    this.fit();
  }

  fit() {
    const box = this.canvases[0].getBoundingClientRect();
    this.scale = Math.max(box.width / this.result.width, box.height / this.result.height);
    this.x = this.result.width / 2;
    this.y = this.result.height / 2;
    this.fitted = true;
    this.draw();
  }

  zoomTo(what) {
    if (what === 'fit')
      return this.fit();
    this.zoom(what === 'in' ? 2 : what === 'out' ? 0.5 : 1 / this.scale, 0, 0);
  }

  /// Keeps what lies `dx`, `dy` CSS pixels from the centre in its place.
  zoom(factor, dx, dy) {
    const scale = Math.min(32, Math.max(1 / 16, this.scale * factor));
    this.x += dx / this.scale - dx / scale;
    this.y += dy / this.scale - dy / scale;
    this.scale = scale;
    this.move(0, 0);
  }

  move(dx, dy) {
    const inside = (value, size) => Math.min(size, Math.max(0, value));
    this.x = inside(this.x - dx / this.scale, this.result.width);
    this.y = inside(this.y - dy / this.scale, this.result.height);
    this.fitted = false;
    this.draw();
  }

  listen(canvas) {
    const pointers = new Map();
    const spread = () => {
      const [a, b] = [...pointers.values()];
      return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
    };
    canvas.addEventListener('pointerdown', (event) => {
      pointers.set(event.pointerId, event);
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (!before)
        return;
      const distance = pointers.size === 2 ? spread() : 0;
      pointers.set(event.pointerId, event);
      if (pointers.size === 2)
        this.zoom(distance > 0 ? spread() / distance : 1, 0, 0);
      else
        this.move(event.clientX - before.clientX, event.clientY - before.clientY);
    });
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
    canvas.addEventListener('wheel', (event) => {
      if (document.activeElement !== canvas && !event.ctrlKey)
        return; // the page scrolls
      event.preventDefault();
      const box = canvas.getBoundingClientRect();
      this.zoom(Math.pow(2, -Math.sign(event.deltaY) / 4),
                event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2);
    }, {passive: false});
    canvas.addEventListener('keydown', (event) => this.press(event));
  }

  press(event) {
    const step = 48; // CSS pixels
    const actions = {
      ArrowLeft: () => this.move(step, 0), ArrowRight: () => this.move(-step, 0),
      ArrowUp: () => this.move(0, step), ArrowDown: () => this.move(0, -step),
      '+': () => this.zoomTo('in'), '=': () => this.zoomTo('in'), '-': () => this.zoomTo('out'),
      '0': () => this.fit(), '1': () => this.zoomTo('one'),
    };
    if (!actions[event.key] || event.ctrlKey || event.metaKey || event.altKey)
      return;
    event.preventDefault();
    actions[event.key]();
  }

  draw() {
    for (const canvas of this.canvases)
      this.drawPane(canvas);
    this.root.querySelector('.zoom').textContent = Math.round(100 * this.scale) + ' %';
  }

  drawPane(canvas) {
    const box = canvas.getBoundingClientRect();
    const density = window.devicePixelRatio || 1;
    canvas.width = Math.max(1, Math.round(box.width * density));
    canvas.height = Math.max(1, Math.round(box.height * density));
    const context = canvas.getContext('2d');
    const scale = this.scale * density;
    context.setTransform(scale, 0, 0, scale, canvas.width / 2 - this.x * scale,
                         canvas.height / 2 - this.y * scale);
    context.imageSmoothingEnabled = scale < 1;
    context.imageSmoothingQuality = 'high';
    const {original, exemplar, result} = this;
    const centred = {original, exemplar}[canvas.dataset.pane];
    if (canvas.dataset.pane === 'result') {
      context.drawImage(result, 0, 0);
    } else if (centred) {
      context.drawImage(centred, (result.width - centred.width) / 2,
                        (result.height - centred.height) / 2);
    } else {
      const repeated = canvas.dataset.pane === 'gaussian' ? this.gaussian : exemplar;
      context.fillStyle = context.createPattern(repeated, 'repeat');
      context.fillRect(0, 0, result.width, result.height);
    }
  }
}

// ---- charts ------------------------------------------------------------------------------------

const kChart = {width: 320, height: 150, left: 8, right: 8, top: 6, bottom: 22};

function svgElement(name, attributes, text) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes))
    made.setAttribute(key, value);
  if (text !== undefined)
    made.textContent = text;
  return made;
}

/// An empty chart of the box's size. `toX` and `toY` take numbers in [0, 1], y upwards.
function chart(label, box) {
  const svg = svgElement('svg', {viewBox: `0 0 ${box.width} ${box.height}`, role: 'img',
                                 'aria-label': label});
  const toX = (x) => box.left + x * (box.width - box.left - box.right);
  const toY = (y) => box.height - box.bottom - y * (box.height - box.top - box.bottom);
  return {
    svg, toX, toY,
    line(x0, y0, x1, y1) {
      svg.append(svgElement('line', {x1: toX(x0), y1: toY(y0), x2: toX(x1), y2: toY(y1),
                                     class: 'grid'}));
    },
    text(x, y, text, anchor) { svg.append(svgElement('text', {x, y, 'text-anchor': anchor}, text)); },
    path(points, className, close) {
      const commands = points.map(([x, y], i) =>
        (i ? 'L' : 'M') + toX(x).toFixed(1) + ' ' + toY(y).toFixed(1)).join('');
      const made = svgElement('path', {d: commands + (close ? 'Z' : ''), class: className});
      svg.append(made);
      return made;
    },
  };
}

/// Bars of equal width as an outline: two points a bar.
function outline(counts, most) {
  return counts.flatMap((count, i) =>
    [[i / counts.length, count / most], [(i + 1) / counts.length, count / most]]);
}

function histogram(data) {
  const figure = document.createElement('div');
  figure.append(element('p', data.channel, 'chart-name'));
  const most = Math.max(...data.exemplar, ...data.result);
  const plot = chart('Histogram of ' + data.channel, kChart);
  plot.path([[0, 0], ...outline(data.exemplar, most), [1, 0]], 'area', true);
  plot.path(outline(data.result, most), 'result');
  plot.line(0, 0, 1, 0);
  for (const [x, anchor] of [[0, 'start'], [0.5, 'middle'], [1, 'end']])
    plot.text(plot.toX(x), kChart.height - 6, shown(x * data.largest), anchor);
  figure.append(plot.svg);
  return figure;
}

/// Colours an element by its place along a path of a mix, if it has one.
function ramp(made, along) {
  if (typeof along !== 'number')
    return;
  made.classList.add('ramped');
  made.style.setProperty('--along', `${(100 * along).toFixed(1)}%`);
}

/// Power in decibels over the frequency in cycles per pixel, which runs in octaves.
function spectrumChart(data, width) {
  const box = {width, height: 300, left: 52, right: 16, top: 10, bottom: 48};
  const lowest = 1 / data.cropSide, highest = 0.5;
  const all = data.curves.flatMap(({power}) => power.slice(1));
  const step = 10; // dB
  const bottom = step * Math.floor(Math.min(...all) / step);
  const top = Math.max(bottom + step, step * Math.ceil(Math.max(...all) / step));
  const plot = chart('Power spectra of exemplar and result', box);
  const x = (frequency) => Math.log2(frequency / lowest) / Math.log2(highest / lowest);
  const y = (power) => (power - bottom) / (top - bottom);
  for (let power = bottom; power <= top; power += step) {
    plot.line(0, y(power), 1, y(power));
    plot.text(box.left - 8, plot.toY(y(power)) + 4, power + (power + step > top ? ' dB' : ''),
              'end');
  }
  for (let frequency = highest; frequency >= lowest * 0.999; frequency /= 2)
    plot.text(plot.toX(x(frequency)), box.height - 26, '1/' + Math.round(1 / frequency), 'middle');
  plot.text(plot.toX(0.5), box.height - 6, 'cycles per pixel', 'middle');
  const curve = (powers) => powers.slice(1).map((power, i) => [x((i + 1) * lowest), y(power)]);
  const drawn = ['exemplar', 'gaussian', 'result']; // the widest line first
  for (const kind of drawn)
    for (const {power, along} of data.curves.filter((c) => c.kind === kind))
      ramp(plot.path(curve(power), kind), along);
  return plot.svg;
}

/// Draws a chart again in every width that its place gets, so that its text keeps its size.
function fill(place, draw) {
  new ResizeObserver(() => {
    if (place.clientWidth > 0)
      place.replaceChildren(draw(place.clientWidth));
  }).observe(place);
}

// ---- the inverse table -------------------------------------------------------------------------

/// The slices of one level, in rows of eight, each level as large as the first.
async function showTable(figure, table) {
  const images = await Promise.all(table.levels.map((level) => loaded(level.picture)));
  const [canvas, slider, output] = ['canvas', 'input', 'output'].map((n) => figure.querySelector(n));
  const first = table.levels[0];
  const side = images[0].width / first.slices;
  const columns = Math.min(8, first.slices), rows = Math.ceil(first.slices / columns);
  const height = Math.max(24, images[0].height); // a table of one row is shown as a band
  canvas.width = side * columns;
  canvas.height = height * rows;
  figure.classList.toggle('flat', first.slices === 1);
  slider.max = table.levels.length - 1;
  const draw = () => {
    const level = Number(slider.value), {slices, lost} = table.levels[level];
    const image = images[level], width = image.width / slices;
    const across = Math.min(columns, slices), down = Math.ceil(slices / across);
    const context = canvas.getContext('2d');
    context.imageSmoothingEnabled = false;
    for (let s = 0; s < slices; ++s)
      context.drawImage(image, s * width, 0, width, image.height,
                        s % across * canvas.width / across,
                        Math.floor(s / across) * canvas.height / down, canvas.width / across,
                        canvas.height / down);
    output.textContent = Math.round(100 * lost) + ' % of the variance lost';
  };
  slider.addEventListener('input', draw);
  draw();
  figure.hidden = false;
}

// ---- texts -------------------------------------------------------------------------------------

/// How a measure stands to its target.
function verdictOn(measure) {
  if (measure.value === null)
    return 'not measured';
  if (measure.target === null)
    return 'no target';
  return measure.met ? 'met' : 'missed';
}

function measureRow(measure) {
  const row = document.createElement('tr');
  const name = element('th', '');
  for (const word of measure.name.split(/(?<=_)/))
    name.append(word, document.createElement('wbr'));
  name.scope = 'row';
  name.append(element('span', measure.meaning + (measure.remark ? '; ' + measure.remark : ''),
                      'detail'));
  const number = (value) => value === null ? '' : shown(value, measure.unit);
  const verdict = verdictOn(measure);
  const mark = {met: '\u2713 ', missed: '\u2717 '}[verdict] ?? '';
  const look = {met: 'good', missed: 'bad'}[verdict] ?? '';
  row.append(name,
             element('td', number(measure.value), 'number'),
             element('td', number(measure.target), 'number target'),
             element('td', mark + verdict, 'verdict ' + look));
  return row;
}

function riskItem(risk) {
  const item = document.createElement('li');
  const look = {none: 'good', mild: 'warn', severe: 'bad'}[risk.level];
  item.append(element('b', risk.name), ' ',
              element('span', `${risk.level}, ${risk.score.toFixed(2)} of 1`, look),
              element('span', risk.sentence, 'detail'));
  if (risk.remedy)
    item.append(element('span', 'What helps: ' + risk.remedy, 'detail'));
  return item;
}

/// The name of a pane of a path, and what else stands below it.
function captionOf(pane) {
  if ('name' in pane)
    return [pane.name, 'share' in pane ? `, ${shown(100 * pane.share)}\u00a0%` : ''];
  const error = `, model error ${shown(pane.modelError)}`;
  return pane.along === null ? ['The mix', error]
                             : [`Step ${pane.step}`, `, weight ${shown(pane.weight)}${error}`];
}

/// A picture with its name below; of the noise also what the shader adds up.
function pathPane(pane) {
  const figure = document.createElement('figure');
  const caption = document.createElement('figcaption');
  const [name, rest] = captionOf(pane);
  const key = element('span', '', 'key ' + ('step' in pane ? 'result' : 'exemplar'));
  ramp(key, pane.along);
  caption.append(key, element('b', name), rest);
  for (const [picture, className] of [[pane, 'noise'], [pane.kernel, 'kernel']]) {
    if (!picture)
      continue;
    const image = new Image();
    image.src = picture.png;
    image.className = className;
    image.alt = className === 'kernel' ? `${picture.title}: ${name}` : name;
    figure.append(image);
  }
  figure.append(caption);
  return figure;
}

async function addMix(mix) {
  const fragment = document.getElementById('mix-template').content.cloneNode(true);
  const isPath = mix.paths[0].panes.every((pane) => pane.along !== null);
  fragment.querySelector('.target').textContent =
    isPath ? `${mix.target}: from input to input` : `${mix.target}: between the inputs`;
  fragment.querySelector('.paths').style.setProperty('--extents', mix.extents.join(' / '));
  for (const path of mix.paths) {
    const part = document.getElementById('path-template').content.cloneNode(true);
    part.querySelector('.panes').append(...path.panes.map(pathPane));
    if (path.spectrum) {
      fill(part.querySelector('.spectrum'), (width) => spectrumChart(path.spectrum, width));
      const inputs = path.panes.filter((pane) => 'name' in pane);
      part.querySelector('.first').textContent = inputs[0].name;
      part.querySelector('.last').textContent = inputs.at(-1).name;
      part.querySelector('.steps').textContent = isPath ? ', thin ones the steps' : ', the thin one the mix';
      part.querySelector('.legend').hidden = false;
    }
    fragment.querySelector('.paths').append(part);
  }
  const images = [...fragment.querySelectorAll('img')];
  document.getElementById('mixes').append(fragment);
  await Promise.all(images.map((image) => image.decode()));
}

/// What a section calls its map.
function titleOf(map) {
  return map.input === null ? map.target : `${map.target} of ${map.input}`;
}

function withImage(figure, {png, title, text}) {
  const image = figure.querySelector('img');
  image.src = png;
  image.alt = title;
  figure.querySelector('.title').textContent = title + '.';
  figure.querySelector('.text').textContent = text;
  return figure;
}

function addFacts(list, facts) {
  for (const [name, value] of facts)
    list.append(element('dt', name), element('dd', value));
}

/// What the page comes to: the verdict, measures over their targets, and risks.
function sayVerdict() {
  if (report.verdict) {
    const line = document.getElementById('judgement');
    line.textContent = `Verdict: ${report.verdict.sentence}`;
    line.className = {good: 'good', unsuitable: 'bad'}[report.verdict.level] ?? 'warn';
    line.hidden = false;
  }
  const isMissed = (measure) => measure.met === false;
  const measures = report.maps.flatMap((map) => map.measures);
  const judged = measures.filter((measure) => measure.met !== null);
  const missed = judged.filter(isMissed).length;
  const missing = report.maps.filter((map) => map.measures.some(isMissed));
  const verdict = document.getElementById('verdict');
  verdict.textContent = missed === 0
    ? `\u2713 All ${judged.length} measures meet their targets.`
    : `\u2717 ${missed} of ${judged.length} measures miss their target: ` + missing.map((map) =>
        map.measures.filter(isMissed).map((measure) => measure.name).join(', ') +
        ` of ${titleOf(map)}`).join('; ') + '.';
  verdict.className = missed === 0 ? 'good' : 'bad';
  verdict.hidden = judged.length === 0;
  const risks = report.maps.flatMap((map) => map.risks.map((risk) => ({...risk, map: titleOf(map)})))
    .filter((risk) => risk.level !== 'none');
  document.getElementById('warning').textContent = risks.length === 0 ? ''
    : '\u26a0 Risks: ' + risks.map((r) => `${r.level} ${r.name} of ${r.map}`).join(', ') + '.';
}

async function addMap(map) {
  const fragment = document.getElementById('map-template').content.cloneNode(true);
  const article = fragment.querySelector('article');
  const find = (selector) => article.querySelector(selector);
  find('.target').textContent = titleOf(map);
  find('.channels').textContent = map.summary;
  find('.measures tbody').append(...map.measures.map(measureRow));
  find('.risks').append(...map.risks.map(riskItem));
  find('.risks-section').hidden = map.risks.length === 0;
  find('.histograms').append(...map.histograms.map(histogram));
  if (map.spectrum) {
    fill(find('.spectrum'), (width) => spectrumChart(map.spectrum, width));
    find('.spectrum-section').hidden = false;
    for (const selector of ['.key.gaussian', '.gaussian-name'])
      find(selector).hidden = !map.spectrum.curves.some(({kind}) => kind === 'gaussian');
  }
  for (const canvas of article.querySelectorAll('.panes canvas'))
    canvas.setAttribute('aria-label', `${titleOf(map)}: ${canvas.dataset.pane}`);
  const figure = find('.image');
  figure.after(...map.furtherImages.map((each) => withImage(figure.cloneNode(true), each)));
  withImage(figure, map.image);
  document.getElementById('maps').append(fragment);
  if (map.table)
    await showTable(find('.table'), map.table);
  find('.steps').textContent = map.steps.map((step) => ', ' + step).join('');
  find('.original').hidden = map.original === null;
  find('figure.gaussian').hidden = map.gaussian === null;
  const panes = article.querySelectorAll('.panes figure:not([hidden])').length;
  find('.panes').classList.toggle('four', panes === 4);
  const [original, exemplar, gaussian, result] = await Promise.all(
    [map.original, map.exemplar, map.gaussian, map.result].map((p) => p && loaded(p)));
  new Viewer(find('.viewer'), {original, exemplar, gaussian, result});
  await Promise.all([...article.querySelectorAll('.image img')].map((image) => image.decode()));
}

async function show() {
  document.title = `${report.name} - ${report.kind} report`;
  document.getElementById('kicker').textContent = `Lichen ${report.kind} report`;
  document.getElementById('facts-heading').textContent = `The ${report.kind}`;
  document.getElementById('name').textContent = report.name;
  document.getElementById('command').textContent = report.command;
  sayVerdict();
  addFacts(document.getElementById('facts'), report.facts);
  addFacts(document.getElementById('timings'),
           report.timings.map(({name, seconds}) => [name, seconds.toFixed(2) + ' s']));
  document.getElementById('notes').append(...report.notes.map((note) => element('li', note)));
  document.getElementById('notes-section').hidden = report.notes.length === 0;
  for (const mix of report.mixes)
    await addMix(mix);
  for (const map of report.maps)
    await addMap(map);
}

show().then(() => document.documentElement.dataset.state = 'complete',
            (error) => {
              document.documentElement.dataset.state = 'failed';
              document.getElementById('verdict').textContent = 'This page is damaged: ' + error;
            });
