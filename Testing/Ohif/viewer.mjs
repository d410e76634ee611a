// Drives OHIF in a browser like a user: opens a study, loads objects, looks at pixels. OHIF publishes window.services, cornerstone and
// cornerstoneTools; functions that run in the page also have window.helpers.

const PAUSE = 500; // milliseconds; OHIF scrolls to a first slice after drawing, and fails if the viewport is replaced before

export const addHelpers = () => {
  const uidOf = (set) => set.SOPInstanceUID || set.instances[0].SOPInstanceUID;
  const sets = () => services.displaySetService.getActiveDisplaySets();
  const viewportId = () => services.viewportGridService.getActiveViewportId();
  globalThis.helpers = {
    uidOf, sets, viewportId,
    setOf: (uid) => sets().find((set) => uidOf(set) === uid),
    viewport: () => services.cornerstoneViewportService.getCornerstoneViewport(viewportId()),
    sliceOf: (imageId) => cornerstone.metaData.get('sopCommonModule', imageId).sopInstanceUID,
  };
};

const show = (uid) => {
  const { displaySetInstanceUID } = helpers.setOf(uid);
  const viewportId = helpers.viewportId();
  services.viewportGridService.setDisplaySetsForViewport({ viewportId, displaySetInstanceUIDs: [displaySetInstanceUID] });
};

const isReport = (uid) => helpers.setOf(uid).Modality === 'SR';

// OHIF asks whether to load an object into the viewport of the CT. Answers and returns whether the object is shown.
const isSegmentationShown = (uid) => {
  document.querySelector('[data-cy="yes-hydrate-btn"]')?.click();
  const segmentationId = helpers.setOf(uid).displaySetInstanceUID;
  const { displaySetInstanceUIDs } = services.viewportGridService.getState().viewports.get(helpers.viewportId());
  const shown = services.segmentationService.getSegmentationRepresentations(helpers.viewportId(), { segmentationId });
  return shown.length > 0 && !displaySetInstanceUIDs.includes(segmentationId);
};

// Answers no for a report, because its viewport then shows all measurements.
const isReportShown = (uid) => {
  const question = document.querySelector('[data-cy="no-hydrate-btn"]');
  question?.click();
  return helpers.setOf(uid).isLoaded && (question || !helpers.setOf(uid).isRehydratable) && helpers.viewport() !== null;
};

const pixelsOf = async (picture) => {
  const bytes = Uint8Array.from(atob(picture), (letter) => letter.charCodeAt(0));
  const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
  context.drawImage(image, 0, 0);
  return [...context.getImageData(0, 0, image.width, image.height).data];
};

// Returns where to press the element with this text, placeholder, role or data-cy, once it is there and uncovered.
const placeOf = (name) => {
  const pressed = [...document.querySelectorAll('button, [role=tab], [role=combobox], [role=option], input, [data-cy]')];
  const namesOf = ({ dataset, textContent, role, placeholder }) => [dataset.cy, textContent.trim(), role, placeholder];
  const element = pressed.find((one) => namesOf(one).includes(name));
  const { x, y, width, height } = element?.getBoundingClientRect() || {};
  const place = [x + width / 2, y + height / 2];
  return element && width > 0 && element.contains(document.elementFromPoint(...place)) && place;
};

const drawn = (page) => page.evaluate(() => new Promise((done) => { requestAnimationFrame(() => requestAnimationFrame(done)); }));

// Opens the study; returns when all its series are listed and the CT is drawn.
export async function open({ page, server, expected }) {
  await page.visit(`${server.url}/app-config.js`);
  await page.evaluate(() => localStorage.setItem('shownTours', JSON.stringify(['basicViewerTour'])));
  await page.visit(`${server.url}/viewer?StudyInstanceUIDs=${expected.study}`);
  await page.until(() => Boolean(globalThis.services?.displaySetService && globalThis.cornerstone));
  await page.evaluate(addHelpers);
  await page.until((count) => helpers.sets().length === count, undefined, expected.objects.length + expected.series);
  await page.until(() => helpers.viewport()?.getImageIds?.().length > 1 && helpers.viewport().viewportStatus === 'rendered');
  await new Promise((done) => { setTimeout(done, PAUSE); });
}

// Returns the pixels [r, g, b] of the page around a point.
export async function look(page, [x, y], radius) {
  await drawn(page);
  const side = 2 * radius + 1;
  const clip = { x: Math.floor(x) - radius, y: Math.floor(y) - radius, width: side, height: side, scale: 1 };
  const { data } = await page.send('Page.captureScreenshot', { format: 'png', clip });
  const bytes = await page.evaluate(pixelsOf, data);
  return Array.from({ length: bytes.length / 4 }, (_, i) => bytes.slice(4 * i, 4 * i + 3));
}

// Loads the segmentation or report with this SOP instance UID.
export async function load({ page }, uid) {
  await page.evaluate(show, uid);
  await page.until(await page.evaluate(isReport, uid) ? isReportShown : isSegmentationShown, undefined, uid);
  await drawn(page);
}

// Presses the element with this text, placeholder, role or data-cy with the mouse.
export async function press(page, name) {
  const place = await page.until(placeOf, undefined, name);
  await page.click(...place);
  await drawn(page);
}
