# Chapter 2: cumulative heat diffusion; read by make-figures.
# shellcheck shell=bash disable=SC2016

chapter 2 'cumulative heat diffusion'

# Lines of the MR head: fluid, eyes, brain, scalp; and of six bones of the foot.
headLines='0.0725-0.0735:skyblue:0.8,0.138-0.1395:skyblue:0.8,0.1505-0.1512:yellow:1,0.2478-0.2495:yellow:1,0.16-0.2:orange:0.8,0.655-0.735:red:0.3'
footLines=0.18-0.1835:tomato:1,0.1848-0.1855:yellow:1,0.198-0.2015:skyblue:1,0.2075-0.2105:lime:1,0.2285-0.2345:orange:1,0.2905-0.2985:violet:1

figure 2.1 'head, abdomen and foot'
needs scivis/mri_ventricles.nii.gz scivis/stent.nii.gz scivis/foot.nii.gz
run CumulativeHeatDiffusion mri_ventricles.nii.gz ventricles.nrrd --snapshots 256 --report ventricles
run HeatTransferFunction mri_ventricles.nii.gz ventricles.nrrd ventricles.vp --lines "$headLines" --picture ventricles.png
run CumulativeHeatDiffusion stent.nii.gz stent-published.nrrd --preset published --p 8
run HeatTransferFunction stent.nii.gz stent-published.nrrd stent.vp --picture stent-published.png
run CumulativeHeatDiffusion stent.nii.gz stent.nrrd
run HeatTransferFunction stent.nii.gz stent.nrrd stent.vp --lines 0.4317-0.7265:ivory:1,0.366-0.387:red:0.5,0.237-0.262:tan:0.06 \
  --picture stent.png
run CumulativeHeatDiffusion foot.nii.gz foot.nrrd --snapshots 256 --snapshotSpacing logarithmic --histogramRange 0.17,0.31 --report foot
run HeatTransferFunction foot.nii.gz foot.nrrd foot.vp --lines "$footLines" --picture foot.png
panels 2 350 "$(rendering ventricles.png)=(a) MR head" "$(rendering stent.png)=(b) abdomen with a stent" \
  "$(rendering foot.png)=(c) foot" "$(histogram foot/histogram-range.png)=(d) foot, heats from 0.17 to 0.31" \
  "stent-published.png@0,700,1110,490=(b) with p = 8, 100,000 steps, as published" "stent.png@0,700,1110,490=(b) ours"
differs '(b) window -160 to 240 HU, p = 25; others chosen from the data. Colors: one per line. **Agrees:** (d) lines converge' \
  'and stay apart, one per bone; (b) spine, ribs and pelvis are one class (ivory), both kidneys are in one line (red).' \
  '**Differs:** the line also contains the muscles beside the spine; liver and pancreas have no line. With p = 8, as published,' \
  'all of (b) is one class.'

figure 2.3 'equalized and normalized histogram'
needs volumes/ch2.nii.gz
run CumulativeHeatDiffusion ch2.nii.gz head.nrrd --p 20 --timeSteps 4000 --snapshotSpacing logarithmic \
  --histogram equalized.png
run CumulativeHeatDiffusion ch2.nii.gz head.nrrd --p 20 --timeSteps 4000 --snapshotSpacing logarithmic \
  --histogram normalized.png --histogramScale normalized
panels 2 430 "$(histogram equalized.png)=(a) equalized" "$(histogram normalized.png)=(b) normalized"
differs 'MR head; the dissertation does not name its data. **Agrees:** equalization assigns space by the number of voxels.'

figure 2.4 'a cube in time'
run ShapePhantom cube.nrrd --shape figure2.4 --size 72,72,72
run CumulativeHeatDiffusion cube.nrrd cube-heat.nrrd --preset published --timeSteps 4000 --snapshotSteps 20,100,750,900,1000,1100 \
  --snapshotFolder cube-steps --histogram cube-histogram.png
cube=()
for step in 20 100 750 900 1000 1100; do
  run HeatTransferFunction cube.nrrd cube-steps "cube-$step.vp" --timeStep $step --lines 0.0236-0.0319:orange:0.4,0.0319-1:red:0.9 \
    --picture "cube-$step.png"
  cube+=("$(rendering "cube-$step.png")=t = $step")
done
panels 3 280 "${cube[@]}" "$(histogram cube-histogram.png)=4000 steps"
differs 'Orange: within 15 % of the final heat; red: hotter. **Agrees:** faces reach the final heat first, then edges, then' \
  'corners; one line remains. **Not comparable:** the steps depend on size and thresholds, which are not printed' \
  '([values](validation/heat.md#figures-24-25-and-27-of-the-dissertation)).'

figure 2.5 'conventional and cumulative heat diffusion'
run ShapePhantom small.nrrd --shape figure2.4 --size 32,32,32
compared=()
for step in 10 30 100; do
  run ConventionalDiffusion small.nrrd small-conventional-$step.nrrd 7 $step
  run heat-slice.py small-conventional-$step.nrrd small-conventional-$step.png 8
  compared+=("small-conventional-$step.png=conventional, $step steps")
done
for step in 10 30 100; do
  run CumulativeHeatDiffusion small.nrrd small-$step.nrrd --preset published --timeSteps $step
  run heat-slice.py small-$step.nrrd small-$step.png 8
  compared+=("small-$step.png=cumulative, $step steps")
done
panels 3 220 "${compared[@]}"
differs 'Middle slice of a cube of side 16 in 32^3 voxels, p = 7; each from its lowest heat (blue) to its highest (red). **Agrees:** cumulative diffusion after 30 steps resembles conventional diffusion after 100; heat stays longest in the corners.'

figure 2.6 'the foot, one line at a time'
needs scivis/foot.nii.gz
run CumulativeHeatDiffusion foot.nii.gz foot-published.nrrd --preset published
run HeatTransferFunction foot.nii.gz foot-published.nrrd foot-published.vp --picture foot-published.png
run CumulativeHeatDiffusion foot.nii.gz foot.nrrd --snapshots 256 --snapshotSpacing logarithmic --histogramRange 0.17,0.31 --report foot
run HeatTransferFunction foot.nii.gz foot.nrrd foot.vp --lines "$footLines" --picture foot.png
bones=("foot-published.png@16,734,380,380=p = 7, 100,000 steps, as published" "foot.png@16,734,380,380=ours, six lines"
  "foot.png@804,734,380,380")
for line in ${footLines//,/ }; do
  run HeatTransferFunction foot.nii.gz foot.nrrd foot.vp --lines "$line" --picture "foot-${line%%:*}.png"
  bones+=("foot-${line%%:*}.png@270,115,480,480=${line%%:*}")
done
panels 3 250 "${bones[@]}"
differs 'Published: p = 7, 100,000 or 1,000,000 steps; with 100,000, all voxels are one class. Ours, chosen from the data: p =' \
  '29.6, 40,000 steps. **Agrees:** the proximal phalanx of each toe has a line. **Differs:** ranges contain stray voxels; bone' \
  'makes up 26 to 85 % of them. Metatarsals are cut by the border and have no line.'

figure 2.7 'scale and orientation'
run ShapePhantom a.nrrd --shape figure2.7a --size 96,96,96
run CumulativeHeatDiffusion a.nrrd a-heat.nrrd --preset published --timeSteps 40000 --histogram a-histogram.png
run HeatTransferFunction a.nrrd a-heat.nrrd a.vp --picture a.png
run ShapePhantom four.nrrd --shape figure2.7b --size 96,96,96
run CumulativeHeatDiffusion four.nrrd four-heat.nrrd --preset published --timeSteps 40000 --histogram four-histogram.png
run HeatTransferFunction four.nrrd four-heat.nrrd four.vp --picture four.png
panels 2 400 "$(rendering a.png)=(a) two spheres, a cube" "$(histogram a-histogram.png)" \
  "$(rendering four.png)=(b) two cubes, two cuboids" "$(histogram four-histogram.png)"
differs '**Agrees:** three and four lines. **Differs:** the lines of one shape in two sizes are not close. The heats of the' \
  'spheres differ by a factor of 2, the ratio of their radii; their `normalizedHeat` differs by 0.1 %' \
  '([values](validation/heat.md#figures-24-25-and-27-of-the-dissertation)).'

figure 2.8 'p'
needs volumes/engine.nii.gz
engine=()
for p in 2 5 10 15; do
  run CumulativeHeatDiffusion engine.nii.gz engine-$p.nrrd --p $p --timeSteps 100
  run HeatTransferFunction engine.nii.gz engine-$p.nrrd engine.vp --lines '0.08-0.2:#3c6bdf:0.15,0.2-1:#dd3d2c:1' \
    --picture engine-$p.png
  engine+=("$(rendering engine-$p.png)=p = $p")
done
panels 2 400 "${engine[@]}"
differs '100 steps; the rendered ranges are our choice. **Agrees:** p = 2 and 5 differ much, 10 and 15 little.'

figure 2.9 'an MR head'
needs scivis/mri_ventricles.nii.gz
run CumulativeHeatDiffusion mri_ventricles.nii.gz ventricles-published.nrrd --preset published --p 6 --timeSteps 400000
run HeatTransferFunction mri_ventricles.nii.gz ventricles-published.nrrd ventricles.vp --picture ventricles-published.png
run CumulativeHeatDiffusion mri_ventricles.nii.gz ventricles.nrrd --snapshots 256 --report ventricles
run HeatTransferFunction mri_ventricles.nii.gz ventricles.nrrd ventricles.vp --lines "$headLines" --picture ventricles.png
parts=('skyblue=(d) fluid' 'yellow=eyes' 'orange=(c) brain' 'red=neck')
headParts=()
for part in "${parts[@]}"; do
  color=${part%%=*}
  lines=$(tr , '\n' <<<"$headLines" | grep ":$color:" | paste -sd,)
  run HeatTransferFunction mri_ventricles.nii.gz ventricles.nrrd ventricles.vp --lines "$lines" --picture "ventricles-$color.png"
  headParts+=("ventricles-$color.png@100,150,640,460=${part#*=}")
done
panels 4 220 "ventricles-published.png@16,734,380,380=p = 6, 400,000 steps, as published" "ventricles.png@16,734,380,380=ours" \
  "ventricles.png@100,150,640,460=(a) all lines" "ventricles.png@410,734,380,190" "${headParts[@]}"
differs 'Published: p = 6, 400,000 steps; in our head these leave heat in only 90 voxels. Ours, chosen from the data: p = 32.7,' \
  '40,000 steps. **Agrees:** eyes, fluid of the ventricles, brain and muscles of the neck have different lines. **Differs:**' \
  'only parts of the brain have a line, and one ventricle shares it; lines contain stray voxels; the cranium (b) has none.' \
  'Slices named axial are sagittal (the header is wrong).'

figure 2.10 'an aneurysm'
needs scivis/aneurism.nii.gz
run CumulativeHeatDiffusion aneurism.nii.gz aneurysm-published.nrrd --preset published --p 7.5
run HeatTransferFunction aneurism.nii.gz aneurysm-published.nrrd aneurysm.vp --picture aneurysm-published.png
run CumulativeHeatDiffusion aneurism.nii.gz aneurysm.nrrd
run HeatTransferFunction aneurism.nii.gz aneurysm.nrrd aneurysm.vp --lines 0.0815-0.095:yellow:1,0.095-0.18:red:1,0.18-0.9:lime:0.6 \
  --picture aneurysm.png
panels 2 420 "$(rendering aneurysm-published.png)=p = 7.5, 100,000 steps, as published" "$(rendering aneurysm.png)=ours" \
  "$(slices aneurysm-published.png)" "$(slices aneurysm.png)"
differs 'Published: p = 7.5, 100,000 steps; these give five classes, in which blob and vessels mix. Ours, chosen' \
  'from the data: p = 8.11. **Agrees:** blob (yellow), large (red) and thin vessels (green) are distinguished, with some' \
  'mixed voxels, as published; heat falls with thickness. **Differs:** we use 1,200 steps.'
