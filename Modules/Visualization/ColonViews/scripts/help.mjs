import { KeyTable } from '../../../Core/Report/scripts/keys.mjs';

// act: name of a method of the viewer, followed by its argument.
const keyList = [
  ['Flight', [
    ['ArrowUp', '↑', 'fly ahead 2 mm', 'fly', 2],
    ['ArrowDown', '↓', 'fly back 2 mm', 'fly', -2],
    ['PageUp', 'Page ↑', 'fly ahead 20 mm', 'fly', 20],
    ['PageDown', 'Page ↓', 'fly back 20 mm', 'fly', -20],
    ['ArrowLeft', '←', 'turn left', 'turn', [-0.15, 0]],
    ['ArrowRight', '→', 'turn right', 'turn', [0.15, 0]],
    ['i', 'I', 'look up', 'turn', [0, 0.15]],
    ['k', 'K', 'look down', 'turn', [0, -0.15]],
    ['r', 'R', 'fly the other way', 'reverse'],
    [' ', 'Space', 'start or stop flying', 'toggleFlight'],
    ['Home', 'Home', 'to the anal verge', 'goTo', 0],
    ['End', 'End', 'to the cecum', 'goTo', Infinity],
  ]],
  ['Crosshair', [
    ['Shift+ArrowRight', 'Shift →', 'right on the flat wall by 2 mm', 'moveFlat', [2, 0]],
    ['Shift+ArrowLeft', 'Shift ←', 'left on the flat wall by 2 mm', 'moveFlat', [-2, 0]],
    ['Shift+ArrowUp', 'Shift ↑', 'up on the flat wall by 2 mm', 'moveFlat', [0, -2]],
    ['Shift+ArrowDown', 'Shift ↓', 'down on the flat wall by 2 mm', 'moveFlat', [0, 2]],
    ['a', 'A', 'next axial slice; Shift: previous', 'stepSlice', [0, 1]],
    ['c', 'C', 'next coronal slice', 'stepSlice', [1, 1]],
    ['s', 'S', 'next sagittal slice', 'stepSlice', [2, 1]],
    ['Shift+a', '', '', 'stepSlice', [0, -1]],
    ['Shift+c', '', '', 'stepSlice', [1, -1]],
    ['Shift+s', '', '', 'stepSlice', [2, -1]],
  ]],
  ['Views', [
    ['1', '1', 'window for the colon: 1500, level -200', 'setWindow', [1500, -200]],
    ['2', '2', 'window for soft tissue: 400, level 40', 'setWindow', [400, 40]],
    ['3', '3', 'window for tagged residue: 2000, level 300', 'setWindow', [2000, 300]],
    ['4', '4', 'wide window: 1536, level -256', 'setWindow', [1536, -256]],
    ['v', 'V', 'select the next view for + and -', 'nextView'],
    ['+', '+', 'enlarge the selected view', 'zoom', 1.25],
    ['-', '-', 'shrink the selected view', 'zoom', 0.8],
    ['o', 'O', 'turn the wall in space', 'turnOutside', 0.3],
    ['x', 'X', 'select the other position for the keys', 'nextPanel'],
  ]],
  ['Reading', [
    ['n', 'N', 'next candidate or finding', 'stepEntry', 1],
    ['p', 'P', 'previous candidate or finding', 'stepEntry', -1],
    ['e', 'E', 'next verdict', 'nextVerdict'],
    ['t', 'T', 'edit the note', 'writeNote'],
    ['f', 'F', 'add a finding at the crosshair', 'addFinding'],
    ['m', 'M', 'measure between two clicks, or stop measuring', 'toggleMeasure'],
    ['Enter', 'Enter', 'measure from or to the crosshair', 'measureHere'],
    ['Ctrl+s', 'Ctrl S', 'save verdicts.json', 'save'],
    ['Ctrl+o', 'Ctrl O', 'open verdicts.json', 'openFile'],
    ['?', '?', 'this help', 'toggleHelp'],
    ['Escape', 'Esc', 'leave help, note or measurement', 'leave'],
  ]],
];

const MOUSE = [
  ['click', 'sets the crosshair in all views'],
  ['Shift and move', 'moves the crosshair'],
  ['drag', 'shifts the flat wall, turns the wall in space and the eye, changes the window of slices'],
  ['drag with the right button', 'shifts the wall in space'],
  ['wheel', 'enlarges the flat wall and the wall in space, scrolls through slices, flies'],
  ['Ctrl and wheel', 'enlarges a slice'],
];

export const viewerKeys = new KeyTable(keyList, MOUSE);
