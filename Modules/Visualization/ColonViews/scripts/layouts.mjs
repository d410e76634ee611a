// Arrangements of the views, as styles of viewer.css.
export const layouts = [
  ['all', 'all views'], ['slices', 'slices large'], ['flat', 'unfolded view large'], ['inside', 'endoluminal view large'],
];

export const layoutAfter = (name) => layouts[(layouts.findIndex(([n]) => n === name) + 1) % layouts.length][0];
