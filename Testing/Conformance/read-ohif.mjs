// read-ohif.mjs PACKAGE WORK FOLDER: prints what OHIF holds of the DICOM files in FOLDER, as JSON: planes of pixels, those of a
// segmentation instead if there is one, or points of a report. PACKAGE receives OHIF from npm, WORK the storage of Orthanc.
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { launch } from '../Browser/browser.mjs';
import { missing, serve } from '../Ohif/ohif.mjs';
import { addHelpers, load } from '../Ohif/viewer.mjs';

const QUIET = 1500; // milliseconds without another display set or image, after which OHIF has listed all
const [PACKAGE, WORK, FOLDER] = process.argv.slice(2);

const filesIn = (folder) => readdirSync(folder, { withFileTypes: true, recursive: true })
  .filter((entry) => entry.isFile()).map((entry) => join(entry.path, entry.name)).sort();

const pause = (ms) => new Promise((done) => { setTimeout(done, ms); });

// ---- functions that run in the page ----
const state = () => JSON.stringify([helpers.sets().map(helpers.uidOf), helpers.viewport()?.viewportStatus]);

const planes = async () => {
  const found = [];
  for (const set of helpers.sets().filter(({ Modality, unsupported }) => !['SEG', 'SR'].includes(Modality) && !unsupported)) {
    const source = globalThis.extensionManager?.getActiveDataSource()[0];
    const ids = source?.getImageIdsForDisplaySet(set) || set.imageIds || set.instances.map(({ imageId }) => imageId);
    for (const id of ids) {
      const image = await cornerstone.imageLoader.loadAndCacheImage(id);
      const { rowCosines, columnCosines, rowPixelSpacing, columnPixelSpacing, imagePositionPatient } =
        cornerstone.metaData.get('imagePlaneModule', id);
      const isScaled = image.preScale?.scaled;
      const [slope, intercept] = isScaled ? [1, 0] : [image.slope ?? 1, image.intercept ?? 0];
      found.push({
        rows: image.rows, columns: image.columns, slope, intercept, pixels: [...image.voxelManager.getScalarData()],
        position: [...imagePositionPatient], orientation: [...rowCosines, ...columnCosines],
        spacing: [rowPixelSpacing, columnPixelSpacing],
      });
    }
  }
  return found;
};

const labels = (uid) => {
  const { representationData } = services.segmentationService.getSegmentation(helpers.setOf(uid).displaySetInstanceUID);
  return representationData.Labelmap.imageIds.map((id) => {
    const image = cornerstone.cache.getImage(id);
    const { rowCosines, columnCosines, rowPixelSpacing, columnPixelSpacing, imagePositionPatient } =
      cornerstone.metaData.get('imagePlaneModule', image.referencedImageId);
    return {
      rows: image.rows, columns: image.columns, slope: 1, intercept: 0, pixels: [...image.voxelManager.getScalarData()],
      position: [...imagePositionPatient], orientation: [...rowCosines, ...columnCosines],
      spacing: [rowPixelSpacing, columnPixelSpacing],
    };
  });
};

const points = () => cornerstoneTools.annotation.state.getAllAnnotations()
  .filter(({ metadata }) => metadata.toolName === 'DICOMSRDisplay').map(({ data }) => [...data.handles.points[0]]);

// Returns the UID of the first object of a modality.
const objectOf = (modality) => {
  const set = helpers.sets().find(({ Modality, unsupported }) => Modality === modality && !unsupported);
  return set && helpers.uidOf(set);
};

// ---- the case ----
async function read(page, server) {
  const [study] = await server.studies();
  if (!study) throw new Error('no file is DICOM');
  await page.visit(`${server.url}/app-config.js`);
  await page.evaluate(() => localStorage.setItem('shownTours', JSON.stringify(['basicViewerTour'])));
  await page.visit(`${server.url}/viewer?StudyInstanceUIDs=${study}`);
  await page.until(() => Boolean(globalThis.services?.displaySetService && globalThis.cornerstone));
  await page.evaluate(addHelpers);
  await page.until(() => helpers.sets().length > 0);
  for (let before = ''; before !== (before = await page.evaluate(state));) await pause(QUIET);
  const files = filesIn(FOLDER).map((file) => file.slice(FOLDER.length));
  const [segmentation, report] = [await page.evaluate(objectOf, 'SEG'), await page.evaluate(objectOf, 'SR')];
  if (files.some((file) => file.endsWith('seg.dcm')) && !segmentation) throw new Error('the segmentation is not shown');
  if (files.some((file) => file.endsWith('sr.dcm')) && !report) throw new Error('the report is not shown');
  if (!segmentation && !report) return { planes: await page.evaluate(planes) };
  await load({ page }, segmentation || report);
  await pause(QUIET);
  return segmentation ? { planes: await page.evaluate(labels, segmentation) } : { points: await page.evaluate(points) };
}

const reason = missing(PACKAGE);
if (reason) throw new Error(reason);
const server = await serve(PACKAGE, WORK);
const page = await launch({ width: 1400, height: 900 });
try {
  for (const file of filesIn(FOLDER)) await server.store(file).catch((error) => { if (file.endsWith('.dcm')) throw error; });
  const found = await read(page, server);
  if (!(found.planes || found.points).length) throw new Error('nothing is shown');
  console.log(JSON.stringify(found));
} finally {
  await page.close();
  await server.close();
}
