# The data sets of the figures; read by make-figures.
# shellcheck shell=bash disable=SC2016

# dataset FILE NAME CREDIT: FILE is the path in the data folder; several files may have one name.
dataset volumes/ch2.nii.gz 'MR head' '`ch2` of the package mricron-data of Debian, MNI, permissive license'
dataset volumes/engine.nii.gz 'engine' 'Open SciVis Datasets, freely used; General Electric, USA'
dataset volumes/bonsai.nii.gz 'bonsai' 'Open SciVis Datasets, freely used; S. Roettger, VIS, University of Stuttgart'
dataset scivis/foot.nii.gz 'foot' 'Open SciVis Datasets; courtesy of volvis.org and Philips Research, Hamburg'
dataset scivis/aneurism.nii.gz 'aneurysm' 'Open SciVis Datasets; courtesy of volvis.org and Philips Research, Hamburg'
dataset scivis/hydrogen_atom.nii.gz 'hydrogen atom' 'Open SciVis Datasets; courtesy of volvis.org and SFB 382 of the DFG'
dataset scivis/mri_ventricles.nii.gz 'MR ventricles' 'Open SciVis Datasets; courtesy of volvis.org and Dirk Bartz, VCM, University of Tuebingen'
dataset scivis/stent.nii.gz 'stent' 'Open SciVis Datasets; courtesy of volvis.org and Michael Meissner, Viatronix Inc., USA'
dataset ctc/walter-reed/prone.nii.gz 'Walter Reed colon' 'Colon Prone, Open SciVis Datasets, at half resolution; courtesy of volvis.org and Walter Reed Army Medical Center, USA'
dataset ctc/gut-cell-atlas/00020-lumen.nrrd 'patient 00020' 'GCA-Models, Edinburgh Gut Cell Atlas, CC BY 4.0'
dataset meshes/SBU_F_Intestine_Large.glb 'SBU colon' 'colon of the HuBMAP CCF reference organs, Stony Brook University, CC BY 4.0'
dataset ctc/colon-lumen-mask.nii.gz 'two positions' 'lumen masks of one patient; no terms are stated, so only values are shown'
dataset ctc/colon-lumen-mask-other-position.nii.gz 'two positions' 'lumen masks of one patient; no terms are stated, so only values are shown'
dataset graphs/power/case118.m 'IEEE 118-bus power grid' 'IEEE 118-bus test case, University of Washington, converted by MATPOWER'
dataset graphs/karate.gml 'karate club' 'W. Zachary, An information flow model for conflict and fission in small groups, 1977; freely used'
dataset graphs/3elt.graph '3elt' 'finite element mesh of the AG-Monien collection, METIS format; freely used'
dataset graphs/rome/grafo4950.50.graphml 'Rome graphs' 'graphs of software engineering, collection of the Graph Drawing symposium, CC BY 4.0'
dataset graphs/rome/grafo3309.59.graphml 'Rome graphs' 'graphs of software engineering, collection of the Graph Drawing symposium, CC BY 4.0'
dataset graphs/rome/grafo8229.70.graphml 'Rome graphs' 'graphs of software engineering, collection of the Graph Drawing symposium, CC BY 4.0'
dataset graphs/temporal 'a network of your own' 'a folder `temporal` with one graph file per step, for example of e-mails per month; it does not belong to our data'
