import { KeyTable } from '../../../Core/Pages/scripts/keys.mjs';

const STEP = 0.12; // fraction of the radius of a view
const keys = [
  ['Select', [
    ['/', '/', 'search by name', 'search'],
    ['n', 'N', 'next node (of the search results)', 'stepNode', 1],
    ['p', 'P', 'previous node', 'stepNode', -1],
    ['e', 'E', 'next edge of the node; Shift: previous', 'stepEdge', 1],
    ['Shift+e', '', '', 'stepEdge', -1],
    ['Enter', 'Enter', 'along the selected edge to its other end', 'follow'],
    ['m', 'M', 'center the selection', 'bring'],
    ['a', 'A', 'track the node in all graphs, in a color of its own; again: no longer', 'track'],
    ['Escape', 'Esc', 'select nothing, leave search or help', 'leave'],
  ]],
  ['Move', [
    ['ArrowLeft', '← → ↑ ↓', 'turn the sphere, move plane and disk', 'move', [-STEP, 0]],
    ['ArrowRight', '', '', 'move', [STEP, 0]],
    ['ArrowUp', '', '', 'move', [0, STEP]],
    ['ArrowDown', '', '', 'move', [0, -STEP]],
    ['Shift+ArrowLeft', 'Shift ← → ↑ ↓', 'same as Shift and drag', 'move', [-STEP, 0, true]],
    ['Shift+ArrowRight', '', '', 'move', [STEP, 0, true]],
    ['Shift+ArrowUp', '', '', 'move', [0, STEP, true]],
    ['Shift+ArrowDown', '', '', 'move', [0, -STEP, true]],
    ['+', '+', 'zoom in', 'zoom', 0.2],
    ['-', '-', 'zoom out', 'zoom', -0.2],
    ['r', 'R', 'reset the view', 'reset'],
    ['v', 'V', 'select the next view for the keys', 'nextView'],
  ]],
  ['Show', [
    ['g', 'G', 'graph', 'flip', 'graph'],
    ['d', 'D', 'dual', 'flip', 'dual'],
    ['o', 'O', 'nodes', 'flip', 'nodes'],
    ['c', 'C', 'circles of nodes', 'flip', 'nodeCircles'],
    ['f', 'F', 'circles of faces', 'flip', 'faceCircles'],
    ['l', 'L', 'labels', 'flip', 'labels'],
    ['t', 'T', 'domains', 'flip', 'tiles'],
    ['k', 'K', 'switch the projection', 'project'],
    ['?', '?', 'this help', 'help'],
  ]],
];

const MOUSE = [
  ['click', 'selects a node, an edge, or the node of a circle; elsewhere: clears the selection'],
  ['Ctrl and click', 'tracks a node in all graphs, or no longer'],
  ['drag', 'turns the sphere, moves plane and disk'],
  ['Shift and drag', 'moves the sphere by a Moebius transformation, turns plane and disk'],
  ['wheel', 'zooms at the pointer'],
];

export const graphKeys = new KeyTable(keys, MOUSE);
