// SPDX-License-Identifier: MIT
// node check.mjs SOURCE_FOLDER FILE...
// Puts bundles to tools that share no code with this project:
// - Khronos glTF-Validator: no error, no warning, and exactly the infos that DESIGN allows;
// - ajv: the extension's JSON schemas accept them, and reach the verdict of schema_cases.json;
// - ktx-parse: every table is a KTX2 file whose levels have the size of their texels.
// Prints one line a check; exit status 1 when one fails.
import fs from 'node:fs';
import path from 'node:path';
import { createRequire } from 'node:module';
import { read as readKtx } from 'ktx-parse';

const require = createRequire(import.meta.url);
const validator = require('gltf-validator');
const Ajv = require('ajv');

const EXTENSION = 'LICHEN_materials_exemplar_noise';
const [sourceFolder, ...files] = process.argv.slice(2);
const extensionFolder = path.join(sourceFolder, 'docs/gltf_extension');

let failures = 0;
function check(ok, what) {
  if (!ok) failures += 1;
  console.log(`${ok ? 'ok  ' : 'FAIL'} ${what}`);
}

/** JSON and buffers of a GLB or of a .gltf with files beside it. */
function readAsset(file) {
  const bytes = fs.readFileSync(file);
  if (file.endsWith('.gltf')) {
    const json = JSON.parse(bytes);
    const binaries = json.buffers.map(({ uri }) =>
      fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri))));
    return { json, binaries };
  }
  const textBytes = bytes.readUInt32LE(12);
  return {
    json: JSON.parse(bytes.subarray(20, 20 + textBytes)),
    binaries: [bytes.subarray(20 + textBytes + 8)],
  };
}

/** The infos that a bundle must have: the unknown extension, the views that only it uses,
 * attributes that only noise uses, and materials that nothing shows when there is no scene. */
function expectedInfos(json) {
  const infos = [`UNSUPPORTED_EXTENSION /extensionsUsed/${json.extensionsUsed.indexOf(EXTENSION)}`];
  for (const table of json.extensions[EXTENSION].tables)
    infos.push(`UNUSED_OBJECT /bufferViews/${table.bufferView}`);
  const hasTexture = (material) => JSON.stringify(material).includes('Texture"');
  json.meshes?.forEach(({ primitives }, mesh) => primitives.forEach((primitive, index) => {
    const material = json.materials[primitive.material];
    const pointer = `/meshes/${mesh}/primitives/${index}/attributes`;
    if (primitive.attributes.TANGENT !== undefined && !material.normalTexture)
      infos.push(`UNUSED_MESH_TANGENT ${pointer}/TANGENT`);
    if (primitive.attributes.TEXCOORD_0 !== undefined && !hasTexture(material))
      infos.push(`UNUSED_OBJECT ${pointer}/TEXCOORD_0`);
  }));
  if (!json.meshes) json.materials.forEach((_, i) => infos.push(`UNUSED_OBJECT /materials/${i}`));
  return infos.sort();
}

async function validate(file) {
  const name = path.basename(file);
  const { json } = readAsset(file);
  const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {
    uri: name,
    externalResourceFunction: async (uri) =>
      new Uint8Array(fs.readFileSync(path.join(path.dirname(file), decodeURIComponent(uri)))),
  });
  const { numErrors, numWarnings, numHints, messages, truncated } = report.issues;
  const infos = messages.map((message) => `${message.code} ${message.pointer}`).sort();
  check(numErrors === 0 && numWarnings === 0 && numHints === 0 && !truncated,
    `${name}: ${numErrors} errors, ${numWarnings} warnings, ${numHints} hints`);
  const expected = expectedInfos(json);
  const agree = JSON.stringify(infos) === JSON.stringify(expected);
  check(agree, `${name}: the infos are those of the extension and its ${expected.length - 1} objects`);
  if (!agree) console.log({ infos, expected });
}

/** The extension's schemas, with what they take from glTF's own reduced to its content. */
function compileSchemas() {
  const ajv = new Ajv({ meta: false, schemaId: 'auto' });
  ajv.addMetaSchema(require('ajv/lib/refs/json-schema-draft-04.json'));
  const property = { properties: { extensions: { type: 'object' }, extras: {} } };
  ajv.addSchema({ type: 'object', ...property }, 'glTFProperty.schema.json');
  ajv.addSchema({ type: 'object', properties: { ...property.properties, name: { type: 'string' } } },
    'glTFChildOfRootProperty.schema.json');
  ajv.addSchema({ type: 'integer', minimum: 0 }, 'glTFid.schema.json');
  ajv.addSchema({ type: 'object', required: ['index'], properties: { ...property.properties,
    index: { $ref: 'glTFid.schema.json' }, texCoord: { type: 'integer', minimum: 0 } } },
  'textureInfo.schema.json');
  const folder = path.join(extensionFolder, 'schema');
  for (const file of fs.readdirSync(folder).sort())
    ajv.addSchema(JSON.parse(fs.readFileSync(path.join(folder, file))), file);
  return (kind) => ajv.getSchema(`${kind}.${EXTENSION}.schema.json`);
}

const schemaOf = compileSchemas();

function schemasAccept(json) {
  const root = json.extensions?.[EXTENSION];
  const uses = json.materials.map((material) => material.extensions?.[EXTENSION])
    .filter((use) => use !== undefined);
  return (root === undefined || schemaOf('glTF')(root)) && uses.every((use) => schemaOf('material')(use));
}

/** add, replace, remove and copy of RFC 6902. */
function applyPatch(document, patch) {
  const copy = structuredClone(document);
  for (const { op, path: pointer, from, value: given } of patch) {
    const value = op === 'copy'
      ? structuredClone(from.split('/').slice(1).reduce((object, key) => object[key], copy))
      : given;
    const keys = pointer.split('/').slice(1);
    const last = keys.pop();
    const parent = keys.reduce((object, key) => object[key], copy);
    if (op === 'remove' && Array.isArray(parent)) parent.splice(Number(last), 1);
    else if (op === 'remove') delete parent[last];
    else if ((op === 'add' || op === 'copy') && Array.isArray(parent))
      parent.splice(last === '-' ? parent.length : Number(last), 0, value);
    else parent[last] = value;
  }
  return copy;
}

function checkSchemaCases() {
  const cases = JSON.parse(
    fs.readFileSync(path.join(sourceFolder, 'tests/cli/gltf_validator/schema_cases.json')));
  for (const { what, example = 'felt.gltf', patch, valid } of cases) {
    const { json } = readAsset(path.join(extensionFolder, 'examples', example));
    check(schemasAccept(applyPatch(json, patch)) === valid,
      `schemas ${valid ? 'accept' : 'refuse'}: ${what}`);
  }
}

/** Bytes of a texel and of a component for each VkFormat that a table may have. */
const FORMATS = new Map([[9, [1, 1]], [16, [2, 1]], [37, [4, 1]], [43, [4, 1]], [76, [2, 2]],
  [83, [4, 2]], [97, [8, 2]], [100, [4, 4]], [109, [16, 4]]]);

function checkTables(file) {
  const { json, binaries } = readAsset(file);
  let sound = true;
  for (const table of json.extensions[EXTENSION].tables) {
    const { buffer, byteOffset, byteLength } = json.bufferViews[table.bufferView];
    const ktx = readKtx(new Uint8Array(binaries[buffer].subarray(byteOffset, byteOffset + byteLength)));
    const [texelBytes, typeSize] = FORMATS.get(ktx.vkFormat);
    const descriptor = ktx.dataFormatDescriptor[0];
    sound &&= ktx.typeSize === typeSize && ktx.supercompressionScheme === 0 && ktx.faceCount === 1;
    sound &&= descriptor.bytesPlane[0] === texelBytes && descriptor.colorModel === 1;
    sound &&= descriptor.samples.length * typeSize === texelBytes;
    sound &&= descriptor.transferFunction === (ktx.vkFormat === 43 ? 2 : 1);
    sound &&= ktx.keyValue.KTXwriter === 'lichen';
    ktx.levels.forEach(({ levelData }, level) => {
      const side = (size) => Math.max(1, size >> level);
      const texels = side(ktx.pixelWidth) * side(ktx.pixelHeight) * side(ktx.pixelDepth);
      sound &&= levelData.byteLength === texels * texelBytes;
    });
  }
  check(sound, `${path.basename(file)}: an independent reader finds its KTX2 tables sound`);
}

for (const file of files) {
  await validate(file);
  checkTables(file);
  check(schemasAccept(readAsset(file).json), `${path.basename(file)}: the schemas accept it`);
}
checkSchemaCases();
const page = fs.readFileSync(path.join(extensionFolder, 'README.md'), 'utf8');
check(schemasAccept(JSON.parse(page.match(/```json\n(.*?)```/s)[1])),
  "README.md: the schemas accept the page's own example");
process.exit(failures === 0 ? 0 : 1);
