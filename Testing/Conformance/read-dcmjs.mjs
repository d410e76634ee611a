// read-dcmjs.mjs FILE...: prints the pixels and planes of uncompressed DICOM files as read by dcmjs, as JSON.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const dcmjs = createRequire(process.cwd() + '/')('dcmjs');
dcmjs.log.setLevel?.('error');

const numbers = (value) => [].concat(value ?? []).map(Number);

function pixelsOf(image) {
  const buffer = [].concat(image.PixelData)[0];
  const signed = image.PixelRepresentation === 1;
  const Words = image.BitsAllocated === 8 ? (signed ? Int8Array : Uint8Array) : signed ? Int16Array : Uint16Array;
  const words = Array.from(new Words(buffer.slice(0, Math.floor(buffer.byteLength / Words.BYTES_PER_ELEMENT) * Words.BYTES_PER_ELEMENT)));
  const unused = 32 - image.BitsStored;
  return words.map((word) => (signed ? (word << unused) >> unused : (word << unused) >>> unused));
}

function planesOf(image) {
  const pixels = pixelsOf(image);
  const count = image.Rows * image.Columns;
  const frames = Number(image.NumberOfFrames ?? 1);
  if (pixels.length < frames * count) throw new Error('the pixels are truncated');
  const groups = [].concat(image.PerFrameFunctionalGroupsSequence ?? [null]);
  const shared = [].concat(image.SharedFunctionalGroupsSequence ?? [{}])[0];
  return groups.map((own, k) => {
    const find = (sequence, plain) => (own ? [].concat(own[sequence] ?? shared[sequence])[0] : plain);
    const rescale = find('PixelValueTransformationSequence', image);
    return {
      rows: image.Rows,
      columns: image.Columns,
      pixels: pixels.slice(k * count, (k + 1) * count),
      slope: Number(rescale.RescaleSlope ?? 1),
      intercept: Number(rescale.RescaleIntercept ?? 0),
      position: numbers(find('PlanePositionSequence', image).ImagePositionPatient),
      orientation: numbers(find('PlaneOrientationSequence', image).ImageOrientationPatient),
      spacing: numbers(find('PixelMeasuresSequence', image).PixelSpacing),
    };
  });
}

const planes = [];
for (const path of process.argv.slice(2)) {
  const bytes = readFileSync(path);
  if (bytes.toString('latin1', 128, 132) !== 'DICM') continue;
  const file = dcmjs.data.DicomMessage.readFile(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  const image = dcmjs.data.DicomMetaDictionary.naturalizeDataset(file.dict);
  const syntax = file.meta['00020010'].Value[0];
  if (!/^1\.2\.840\.10008\.1\.2(\.1|\.1\.99)?$/.test(syntax)) throw new Error('pixels are left to the caller: ' + syntax);
  const own = planesOf(image);
  const places = own.flatMap((plane) => [...plane.position, ...plane.orientation, ...plane.spacing]);
  if (!places.every(Number.isFinite)) throw new Error('a number of the plane is missing or malformed');
  planes.push(...own);
}
console.log(JSON.stringify(planes));
