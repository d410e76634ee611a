# Chapter 5: flat colons; read by make-figures.
# shellcheck shell=bash disable=SC2016

chapter 5 'flat colons'
write 'Published: heat diffusion distances from 50 eigenpairs, t = 8, walls of 55,000 faces with their handles. Ours, unless stated: all' \
  'eigenpairs ([why](validation/flattening.md#eigenpairs-and-times-of-the-heat-diffusion-metric)), t from the mesh, and more faces.' \
  'Walter Reed and patient 00020: see chapter 4.' ''

figure 5.1 'a colon with handles, and its flat map'
raw_wall
walter_reed
run SurfaceColors patient-20/segmentation/wall.vtp handle.png near=249.5,86,432.5,13 elevation=25
panels 3 290 "patient-20/segmentation/report/wall-anterior.png@200,10,600,850=(a) patient 00020; its wall has 21 handles" \
  "patient-20/polyps/report/polyp-candidate-2.png=a candidate beside a fold, inside and flat" "handle.png=(a) a handle" \
  "raw/flat-relief.png@0,1060,420,270=(b) patient 00020, with handles (crosses)" \
  "walter-reed/flattening/report/flat-volume.png@30,1070,420,270=(b) Walter Reed, volume rendering"
differs '**Agrees:** the wall is flattened with its handles, and folds keep their shape. **Differs:** a polyp on a stalk does' \
  'not: a conformal map shrinks its head to a point, and the tool says so.'

figure 5.2 'geodesic and diffusion distance'
write '![Figure 5.2](validation/figure-5.2.png)' ''
paragraph 'Made by `Utilities/run-validation flattening-distances`. **Agrees** for times as in flattening: when thumb and index' \
  'finger are cut apart, f changes by 29.6 % with geodesic and by 3.5 % with diffusion distances' \
  '([values](validation/flattening.md#figure-52-geodesic-and-diffusion-distance)).'

figure 5.3 'slit maps'
needs meshes/SBU_F_Intestine_Large.glb
cecum=VH_F_ca""ecum # the spelling of the file, which is not ours
run ConformalMap SBU_F_Intestine_Large.glb cecum.vtp --part $cecum --component 1 --picture cecum.png --forms cecum-forms.png
panels 1 720 "cecum.png=(a) to (c): a real cecum; its holes lead to the colon (yellow) and to the appendix (red)" \
  "cecum-forms.png=(d) harmonic 1-form, (e) its conjugate, (f) holomorphic 1-form"
write '![Figure 5.3](validation/figure-5.3.png)' ''
differs 'The cecum of the SBU colon, 458 faces, n = 1; above, a generated face with n = 3 as published' \
  '([values](validation/flattening.md#figure-53-a-face-with-three-holes)). **Agrees:** squares stay squares, and' \
  'boundaries become circles and slits.'

figure 5.4 'a pot with and without its handle'
write '![Figure 5.4](validation/figure-5.4.png)' ''
paragraph 'Made by `Utilities/run-validation flattening-handle`. **Agrees:** cutting the handle changes the modulus less in the' \
  'heat diffusion metric, but at best by a factor of 0.35, and only for times much longer than the square of its radius' \
  '([values](validation/flattening.md#figure-54-a-pot-with-and-without-its-handle)).'

figure 5.5 'the ascending colon with handles'
raw_wall
run ColonSegmentation 00020-lumen.nrrd raw-segmentation --inputIsLumen --faces 55000 --topology raw
run ColonFlattening raw-segmentation/wall-simplified.vtp raw-simplified.vtp --centerline raw-segmentation/centerline.vtp
run ColonLandmarks raw-simplified.vtp raw-segmentation/centerline.vtp raw-landmarks --split
run SurfaceRicciFlow raw-landmarks/segment-ascending.vtp ricci.vtp --picture ricci.png
panels 1 660 "ricci.png=(a) surface Ricci flow: wall in space, and in the Poincare disk" \
  "raw/flat-relief.png@0,1375,817,337=(b) heat diffusion, with handles (crosses)" \
  "patient-20/flattening/report/flat-relief.png@0,1035,943,341=heat diffusion, without handles"
differs 'Patient 00020. (a) The ascending segment has two handles, so the metric of curvature -1 is laid out in the disk.' \
  '**Agrees:** the Ricci flow map loses the global shape; with heat diffusion and 21 handles, the map has the course and' \
  'the folds of the one without. **Differs:** at each handle, the map folds over (0.5 % of all faces). Ours is vertex' \
  'scaling with flips; the published scheme is not stated.'

figure 5.6 'polyps'
walter_reed
patient_20
panels 4 240 "patient-20/polyps/report/polyp-candidate-3.png=00020: sessile, 5 mm" \
  "walter-reed/polyps/report/polyp-candidate-2.png@1036,0,402,656=Walter Reed: sessile, 4 mm" \
  "patient-20/polyps/report/polyp-candidate-2.png=00020: beside a fold, 7 mm" \
  "walter-reed/polyps/report/polyp-candidate-1.png@1036,0,402,656=Walter Reed: on a stalk, 9 mm"
differs '**Agrees:** sessile candidates (blue) are bumps on the flat map; the one hidden beside a fold is seen there. **Differs:** a' \
  'head on a stalk is not drawn; ours are not confirmed by optical colonoscopy.'

figure 5.7 'registered ascending colon'
both_positions
as_published
panels 2 370 "both/report/aligned.png@840,580,539,478=(a) supine, (b) prone, as mapped" \
  "both-published/report/aligned.png@840,580,539,478=the same, as published" \
  "patient-20/polyps/report/polyp-candidates-flat.png@900,108,380,240=(a) supine: candidate 2" \
  "patient-20/polyps/report/polyp-candidates-flat.png@520,782,380,240=(a) supine: candidate 3" \
  "second/polyps/report/polyp-candidates-flat.png@905,108,380,240=(b) prone: the first, number 3" \
  "second/polyps/report/polyp-candidates-flat.png@540,776,380,240=(b) prone: the second, number 2"
differs 'Published: mean error 8.14 mm in space, 0.0385 on the map, at 16 pairs of points. As published, ours has 5.5 mm and' \
  '0.034 at 1,501 points, with 347 inverted triangles; our default 1.8 mm and 0.0104, with none. **Agrees:** folds are' \
  'aligned, two candidates are found in both positions, and the published method reaches the published error. **Not' \
  'comparable:** our second position is simulated, and handles are removed before.'

figure 5.8 'handles found on the flat colon'
raw_wall
walter_reed
run ColonFlattening walter-reed/segmentation/wall.vtp walter-reed-raw.vtp --centerline walter-reed/segmentation/centerline.vtp \
  --statistics walter-reed-raw.json --handles walter-reed-handles.vtp
run FlatCurvature raw.vtp handles-all.png 1830 2733 -30 150 2
run FlatCurvature raw.vtp handles-four.png 2165 2195 15 37 0
panels 1 680 "handles-all.png=patient 00020, transverse to cecum; red: Gaussian curvature" \
  "raw/flat-relief.png@0,1375,817,337=relief; crosses: handles" "handles-four.png@150,330,700,260=four handles near 164 cm"
differs 'Published: 43 handles on a third of a colon. **Agrees:** green: no curvature; in patient 00020, 21 of 21 handles are' \
  'found, and 25 other places are recognized as false alarms. **Differs:** the 250 handles of Walter Reed, where parts of' \
  'the colon touch, are found as 105 places.'

figure 5.9 'a whole flat colon'
walter_reed
panels 1 720 "walter-reed/polyps/report/polyp-candidates-flat.png@0,65,1409,1005"
differs 'Walter Reed, from rectum (left) to cecum. Yellow: candidates; blue: valve, gas or fluid; hatched: not evaluable.' \
  '**Agrees:** folds and small candidates are visible. **Differs:** the published volume rendering is in 5.1 (b).'

# rows_of_table CASE: measures the wall of an examination and two of its segments.
rows_of_table() {
  run ColonLandmarks "$1/flattening/flat.vtp" "$1/segmentation/centerline.vtp" "$1-split" --split --report "$1-split/report"
  run FlatteningPeers "$1/segmentation/wall-simplified.vtp" "$1-times.json"
  for segment in ascending transverse; do
    run FlatteningPeers "$1-split/segment-$segment.vtp" "$1-times-$segment.json"
  done
}

figure table-5.1 'seconds for flattening'
patient_20
walter_reed
rows_of_table patient-20
rows_of_table walter-reed
run ColonSegmentation 00020-lumen.nrrd raw-20 --inputIsLumen --faces 55000 --topology raw
run FlatteningPeers raw-20/wall-simplified.vtp raw-20-times.json
table times 'patient 00020=patient-20-times.json' '00020 A=patient-20-times-ascending.json' \
  '00020 T=patient-20-times-transverse.json' 'patient 00020, with handles=raw-20-times.json' 'Walter Reed=walter-reed-times.json' \
  'Walter Reed A=walter-reed-times-ascending.json' 'Walter Reed T=walter-reed-times-transverse.json'
differs 'A, T: ascending, transverse colon. Published: one core at 1.87 GHz. Ours: two busy cores. **Agrees:** Ricci flow takes 8 to 9' \
  'times as long as flattening (published: 9 to 12) and fails with handles; handles are removed faster by curvature than by' \
  'loops. **Differs:** three times, not 285; Ricci flow also fails on two segments (double precision); the 34 harmonic forms of' \
  '17 handles share one factorization and take 1.4 times as long as flattening.'
