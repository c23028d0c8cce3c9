// SPDX-License-Identifier: MIT
// Opens reports of `lichen bake --report` and `lichen mix --report` in Chromium, from files and
// without a network, and looks at what a person would.
// node check.mjs CHROMIUM REPORT.html NAME tiling|texton|mix [SCREENSHOT_FOLDER]
import assert from 'node:assert/strict';
import {createHash} from 'node:crypto';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';

const [executablePath, report, expectedName, method, screenshots] = process.argv.slice(2);
const address = pathToFileURL(report).href;
const kind = method === 'mix' ? 'mix' : 'bake';
const sections = method === 'mix' ? 2 : 1; // a mix has one for each input
const kPhone = {width: 390, height: 844};

// A container's root user has no sandbox.
const browser = await chromium.launch({executablePath, args: ['--no-sandbox']});

/// Opens the report; every console error, page error and request but for the file itself is kept.
async function open(options) {
  const context = await browser.newContext({offline: true, ...options});
  const page = await context.newPage();
  const faults = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()))
      faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('request', (request) => {
    if (request.url() !== address && !request.url().startsWith('data:'))
      faults.push('requested ' + request.url());
  });
  await page.goto(address);
  await page.waitForSelector('html[data-state]', {timeout: 10000});
  assert.equal(await page.evaluate(() => document.documentElement.dataset.state), 'complete');
  return {page, faults};
}

async function shoot(page, name) {
  const image = await page.screenshot({
    fullPage: true, path: screenshots && join(screenshots, name + '.png')});
  return createHash('sha256').update(image).digest('hex');
}

/// The pixels of each pane of the first section, as a digest.
function paneDigests(page) {
  return page.$eval('.viewer', (viewer) => [...viewer.querySelectorAll('figure:not([hidden]) canvas')].map(
    (canvas) => canvas.toDataURL()));
}

const checks = {
  async 'the page shows its name, as text, and every measure'({page}) {
    assert.equal(await page.textContent('h1'), expectedName);
    assert.equal(await page.title(), `${expectedName} - ${kind} report`);
    assert.equal(await page.textContent('#kicker'), `Lichen ${kind} report`);
    const names = await page.$$eval('.measures tbody th',
                                    (cells) => cells.map((cell) => cell.querySelector('.detail').remove() ?? cell.textContent));
    const expected = {
      tiling: ['color_distance', 'spectrum_distance_db', 'autocovariance_error', 'seam_visibility',
               'lattice_visibility'],
      texton: ['color_distance', 'spectrum_distance_db', 'gaussian_spectrum_distance_db',
               'autocovariance_error', 'seam_visibility', 'model_error', 'flatness'],
    };
    expected.mix = [...expected.texton, ...expected.texton];
    assert.deepEqual(names, expected[method]);
    const verdicts = await page.$$eval('.measures td:last-child', (a) => a.map((b) => b.textContent));
    assert.ok(verdicts.every((verdict) => /met|missed|no target|not measured/.test(verdict)));
    assert.ok((await page.textContent('#command')).startsWith(`lichen ${kind} `));
    assert.equal(await page.locator('b:text-is("hostile")').count(), 0);
  },

  async 'every picture of the data decodes, and every pane shows something'({page}) {
    const sizes = await page.evaluate(async () => {
      const uris = document.getElementById('data').textContent.match(/data:image[^"]+/g);
      return Promise.all(uris.map(async (uri) => {
        const image = new Image();
        image.src = uri;
        await image.decode();
        return image.naturalWidth * image.naturalHeight;
      }));
    });
    const steps = method === 'mix' ? 5 : 0; // each with its texton; and the exemplars
    // Of tiling three panes and the levels of its table.
    const levels = method === 'tiling' ? 5 : 1;
    assert.equal(sizes.length, (3 + levels) * sections + (steps > 0 ? 2 + 2 * steps : 0));
    assert.ok(sizes.every((size) => size > 0));
    const panes = await paneDigests(page);
    assert.equal(panes.length, method === 'tiling' ? 3 : 4);
    assert.equal(new Set(panes).size, panes.length);
  },

  async 'zoom and movement change all panes together, and magnified texels are squares'(
      {page}) {
    const before = await paneDigests(page);
    const zoom = () => page.textContent('.zoom');
    const fitted = await zoom();
    await page.click('button[data-zoom="in"]');
    const doubled = 2 * parseInt(fitted, 10); // of what is shown, which is rounded
    assert.ok(Math.abs(parseInt(await zoom(), 10) - doubled) <= 1, `${await zoom()} of ${fitted}`);
    const zoomed = await paneDigests(page);
    zoomed.forEach((digest, i) => assert.notEqual(digest, before[i]));
    await page.focus('canvas[data-pane="result"]');
    await page.keyboard.press('ArrowRight');
    (await paneDigests(page)).forEach((digest, i) => assert.notEqual(digest, zoomed[i]));
    for (let i = 0; i < 5; ++i)
      await page.keyboard.press('+');
    assert.equal(await zoom(), '3200 %');
    // Across one texel of 32 pixels there is one colour, or at most two where it begins or ends.
    const colours = await page.$eval('canvas[data-pane="result"]', (canvas) => {
      const row = canvas.getContext('2d').getImageData(canvas.width / 2, canvas.height / 2, 32, 1);
      return new Set(new Uint32Array(row.data.buffer)).size;
    });
    assert.ok(colours <= 2, `${colours} colours`);
    await page.keyboard.press('0');
    assert.deepEqual(await paneDigests(page), before);
  },

  async 'the wheel zooms a pane that was clicked, and dragging moves it'({page}) {
    const canvas = page.locator('canvas[data-pane="exemplar"]').first();
    await canvas.click();
    await page.mouse.wheel(0, -100);
    const zoomed = await paneDigests(page);
    await page.mouse.down();
    await page.mouse.move(200, 400);
    await page.mouse.up();
    assert.notDeepEqual(await paneDigests(page), zoomed);
  },

  async 'the spectrum of a texton is beside the Gaussian one'({page}) {
    const isTexton = method !== 'tiling';
    assert.equal(await page.locator('.gaussian-name').first().isVisible(), isTexton);
    assert.equal(await page.locator('.spectrum path.gaussian').count(), isTexton ? sections : 0);
  },

  async 'a mix shows its inputs, the steps between them with their textons, and all spectra'({page}) {
    const images = (selector) => page.$$eval(selector, (all) => all.map((image) => image.src));
    const steps = method === 'mix' ? 5 : 0;
    assert.equal(new Set(await images('.path .noise')).size, steps > 0 ? steps + 2 : 0);
    assert.equal(new Set(await images('.path .kernel')).size, steps);
    const curves = (name) => page.locator(`.path .spectrum path.${name}`).count();
    assert.deepEqual([await curves('exemplar'), await curves('result')], [steps > 0 ? 2 : 0, steps]);
    const coloursOf = (selector, property) => page.$$eval(
      selector, (all, name) => all.map((one) => getComputedStyle(one)[name]), property);
    const drawn = await coloursOf('.path .spectrum path.result', 'stroke');
    assert.equal(new Set(drawn).size, steps);
    assert.deepEqual(await coloursOf('.path .key.result', 'backgroundColor'), drawn);
  },

  async 'the slider shows other levels of the inverse table'({page}) {
    assert.equal(await page.locator('.table').first().isVisible(), method === 'tiling');
    if (method !== 'tiling')
      return;
    const shown = () => page.$eval('.table canvas', (canvas) => canvas.toDataURL());
    const first = await shown();
    await page.focus('.table input');
    await page.keyboard.press('End');
    assert.notEqual(await shown(), first);
    assert.equal(await page.textContent('.table output'), '96 % of the variance lost');
  },
};

let failed = 0;
async function check(name, operation) {
  try {
    await operation();
    console.log('passed: ' + name);
  } catch (error) {
    ++failed;
    console.error(`FAILED: ${name}\n${error.message}`);
  }
}

for (const [name, operation] of Object.entries(checks))
  await check(name, async () => {
    const opened = await open({});
    await operation(opened);
    assert.deepEqual(opened.faults, []);
    await opened.page.context().close();
  });

await check('dark and light look different', async () => {
  const light = await open({colorScheme: 'light', viewport: {width: 1280, height: 900}});
  const dark = await open({colorScheme: 'dark', viewport: {width: 1280, height: 900}});
  assert.notEqual(await shoot(light.page, 'light'), await shoot(dark.page, 'dark'));
  const background = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.notEqual(await background(light.page), await background(dark.page));
  assert.deepEqual([...light.faults, ...dark.faults], []);
});

await check('a time is in one line, in windows of any width', async () => {
  const {page, faults} = await open({viewport: {width: 1000, height: 800}});
  await shoot(page, 'window');
  for (const width of [1000, 1280, 720, kPhone.width]) {
    await page.setViewportSize({width, height: 800});
    const lines = await page.$$eval('#timings dd', (cells) => cells.map((cell) => {
      const text = document.createRange();
      text.selectNodeContents(cell);
      return text.getBoundingClientRect().height / parseFloat(getComputedStyle(cell).lineHeight);
    }));
    assert.ok(lines.every((count) => count < 1.5), `${lines} lines at ${width} pixels`);
  }
  assert.deepEqual(faults, []);
});

await check('nothing is wider than a phone, and not than the narrowest one either', async () => {
  const {page, faults} = await open({viewport: kPhone, deviceScaleFactor: 2});
  await shoot(page, 'phone');
  for (const width of [kPhone.width, 320]) {
    await page.setViewportSize({...kPhone, width});
    const widest = await page.evaluate(() => Math.max(
      document.documentElement.scrollWidth,
      ...[...document.querySelectorAll('body *')].map((e) => e.getBoundingClientRect().right)));
    assert.ok(widest <= width, `${widest} pixels`);
  }
  assert.deepEqual(faults, []);
});

await browser.close();
process.exitCode = failed === 0 ? 0 : 1;
