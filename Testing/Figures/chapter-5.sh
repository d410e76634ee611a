# Chapter 5: flat colons; read by make-figures.
# shellcheck shell=bash disable=SC2016

chapter 5 'flat colons'
write 'Published: heat diffusion distances from 50 eigenpairs, t = 8, walls of 55,000 faces with their handles. Ours, unless stated: all' \
  'eigenpairs ([why](validation/flattening.md#eigenpairs-and-times-of-the-heat-diffusion-metric)), t from the mesh, and more faces.' \
  'Walter Reed and patient 00020: see chapter 4.' ''

figure 5.1 'a colon with handles, and its flat map'
raw_wall
walter_reed
panels 2 400 "patient-20/segmentation/report/wall-anterior.png@200,10,600,850=(a) patient 00020; its wall has 21 handles" \
  "walter-reed/polyps/report/polyp-candidate-1.png@812,0,402,656=a polyp of Walter Reed, inside and flat" \
  "raw/flat-relief.png@0,1030,817,334=(b) patient 00020, flat with handles (crosses)" \
  "walter-reed/flattening/report/flat-volume.png@0,1045,874,330=(b) Walter Reed, by direct volume rendering"
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
differs 'Patient 00020. (a) The ascending segment has two handles, so no flat metric has straight boundaries; the metric of' \
  'curvature -1 is laid out in the disk. **Agrees:** the Ricci flow map loses the global shape; with heat diffusion and' \
  '21 handles, the map has the course and the folds of the one without. **Differs:** at each handle, the map folds over' \
  '(0.5 % of all faces), and the wall around it is smeared (at 190 cm). The moduli from u and v differ by 15 %, without' \
  'handles by 0.2 %. Ours is vertex scaling with flips; the published scheme is not stated.'

figure 5.6 'polyps'
walter_reed
panels 3 330 "walter-reed/polyps/report/polyp-candidate-1.png@812,0,402,656=candidate 1" \
  "walter-reed/polyps/report/polyp-candidate-2.png@812,0,402,656=candidate 2" \
  "walter-reed/polyps/report/polyp-candidate-4.png@812,0,402,656=candidate 4"
differs 'Walter Reed. Candidate 1 (10 mm) is a polyp on a stalk, 2 and 4 are possible polyps of 4 and 5 mm. **Agrees:** a' \
  'close-up shows small bumps on the flat map. **Differs:** ours are not confirmed by optical colonoscopy.'

figure 5.7 'registered ascending colon'
both_positions
panels 1 560 "both/report/aligned.png@840,580,539,478=(a) supine, (b) prone, as mapped"
differs 'Published: mean error 8.14 mm in space, 0.0385 on the map, at 16 pairs of points. As published, ours has 5.5 mm and' \
  '0.034 at 1,501 points, with 347 inverted triangles; our default 1.8 mm and 0.0104, with none. **Agrees:** folds are' \
  'aligned, and the published method reaches the published error. **Not comparable:** our second position is simulated,' \
  'and handles are removed before.'

figure 5.8 'handles found on the flat colon'
raw_wall
walter_reed
run ColonFlattening walter-reed/segmentation/wall.vtp walter-reed-raw.vtp --centerline walter-reed/segmentation/centerline.vtp \
  --statistics walter-reed-raw.json --handles walter-reed-handles.vtp
panels 1 680 "raw/flat-relief.png@0,1030,817,334=patient 00020, transverse" "raw/flat-relief.png@0,1375,817,337=transverse to cecum"
differs 'Published: 43 handles on a third of a colon. Ours: crosses. **Agrees:** in patient 00020, 21 of 21 handles are found;' \
  '25 other places are recognized as false alarms. **Differs:** the 250 handles of Walter Reed are found as 105 places,' \
  'of which one has 17 handles and one a radius of 6 cm, because parts of the colon touch. There, the repaired surface is' \
  'required.'

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
