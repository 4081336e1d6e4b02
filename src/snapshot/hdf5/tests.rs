use super::super::testing::{Place, small};
use super::super::{Column, Snapshot};
use super::*;
use hdf5_pure::{AttrValue, FileBuilder};
use std::path::Path;

fn refused(path: &Path) -> String {
    read(path).unwrap_err().to_string()
}

/// Places are moved to a box that begins at zero and back; here without rounding, for they are sums of powers of two.
#[test]
fn what_is_written_is_read_back() {
    let place = Place::new("hdf5");
    for dimension in 1..=3 {
        let path = place.path("a.hdf5");
        let snapshot = small(dimension);
        write(&snapshot, &path).unwrap();
        let found = read(&path).unwrap();
        assert_eq!((found.dimension(), found.time(), found.ids()), (dimension, Some(0.1), snapshot.ids()));
        assert_eq!(found.frame(), snapshot.frame());
        assert_eq!(found.columns().len(), snapshot.columns().len());
        for column in snapshot.columns() {
            let same = found.columns().iter().find(|c| c.name == column.name).unwrap();
            assert_eq!(same.unit, column.unit, "{}", column.name);
            let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&same.values), bits(&column.values), "{}", column.name);
        }
    }
}

#[test]
fn a_snapshot_without_time_box_or_ids_gets_none() {
    let place = Place::new("bare");
    let path = place.path("a.hdf5");
    let bare = Snapshot::new(1, vec![Column::new("x", "", vec![-1.5, 0.5])]).unwrap();
    write(&bare, &path).unwrap();
    assert_eq!(read(&path).unwrap(), bare);
}

#[test]
fn dust_is_a_type_of_its_own() {
    let place = Place::new("dust");
    let path = place.path("a.hdf5");
    let mut columns = small(2).columns().to_vec();
    columns.push(Column::new("particle_type", "", vec![0.0, 1.0, 0.0]));
    let snapshot = Snapshot::new(2, columns).unwrap().with_ids(vec![7, 3, 9]).unwrap();
    write(&snapshot, &path).unwrap();
    let file = hdf5_pure::File::open(&path).unwrap();
    let mass = |kind| file.dataset(&format!("PartType{kind}/Masses")).unwrap().read_f64().unwrap();
    assert_eq!((mass(0), mass(1)), (vec![1.0, 2.0], vec![5e-300]));
    let found = read(&path).unwrap();
    assert_eq!(found.ids(), Some(&[7, 9, 3][..]));
    assert_eq!(found.column("particle_type"), Some(&[0.0, 0.0, 1.0][..]));
    let wrong = Snapshot::new(1, vec![Column::new("x", "", vec![0.0]), Column::new("particle_type", "", vec![0.5])]);
    assert!(write(&wrong.unwrap(), &path).unwrap_err().to_string().contains("particle_type of particle 0 is 0.5"));
}

/// Single precision, other names, masses in a table, no word on dimensions: as other codes write.
#[test]
fn another_codes_file_is_read() {
    let place = Place::new("swift");
    let path = place.path("swift.hdf5");
    let mut file = FileBuilder::new();
    let mut header = file.create_group("Header");
    header.set_attr("NumPart_ThisFile", AttrValue::U64Array(vec![2, 5, 0, 0, 0, 0]));
    header.set_attr("MassTable", AttrValue::F64Array(vec![0.25, 0.0, 0.0, 0.0, 0.0, 0.0]));
    header.set_attr("Time", AttrValue::F64Array(vec![0.5]));
    header.set_attr("BoxSize", AttrValue::F64Array(vec![1.0; 3]));
    file.add_group(header.finish());
    let mut gas = file.create_group("PartType0");
    gas.create_dataset("Coordinates").with_f64_data(&[0.1, 0.2, 0.0, 0.3, 0.4, 0.0]).with_shape(&[2, 3]);
    gas.create_dataset("Velocities").with_f32_data(&[1.0, 2.0, 0.0, 3.0, 4.0, 0.0]).with_shape(&[2, 3]);
    gas.create_dataset("SmoothingLengths").with_f32_data(&[0.5, 0.25]);
    gas.create_dataset("Densities").with_f32_data(&[1.0, 2.0]);
    gas.create_dataset("ParticleIDs").with_i64_data(&[4, 2]);
    file.add_group(gas.finish());
    file.write(&path).unwrap();
    let found = read(&path).unwrap();
    assert_eq!((found.dimension(), found.time(), found.ids()), (2, Some(0.5), Some(&[4, 2][..])));
    assert_eq!(found.column("y"), Some(&[0.2, 0.4][..]));
    assert_eq!(found.column("velocity_y"), Some(&[2.0, 4.0][..]));
    assert_eq!(found.column("mass"), Some(&[0.25, 0.25][..]));
    assert_eq!(found.column("smoothing_length"), Some(&[0.5, 0.25][..]));
    assert_eq!(found.column("density"), Some(&[1.0, 2.0][..]));
    assert_eq!(found.column("velocity_z"), None);
}

/// Every length a file can be cut to: never a panic, never the whole snapshot.
#[test]
fn a_file_cut_short_is_refused_wherever_it_is_cut() {
    let place = Place::new("cut");
    let (whole, cut) = (place.path("whole.hdf5"), place.path("cut.hdf5"));
    write(&small(2), &whole).unwrap();
    let bytes = std::fs::read(&whole).unwrap();
    for length in (0..bytes.len()).step_by(7).chain([bytes.len() - 1]) {
        std::fs::write(&cut, &bytes[..length]).unwrap();
        let message = refused(&cut);
        assert!(message.contains("cut.hdf5: "), "{length} of {}: {message}", bytes.len());
    }
}

fn with_gas(fill: impl FnOnce(&mut hdf5_pure::GroupBuilder), count: u64) -> FileBuilder {
    let mut file = FileBuilder::new();
    let mut header = file.create_group("Header");
    header.set_attr("NumPart_ThisFile", AttrValue::U64Array(vec![count, 0, 0, 0, 0, 0]));
    file.add_group(header.finish());
    let mut gas = file.create_group("PartType0");
    fill(&mut gas);
    file.add_group(gas.finish());
    file
}

#[test]
fn what_is_wrong_is_named_with_its_dataset() {
    let place = Place::new("wrong");
    let path = place.path("a.hdf5");
    let message = |count, fill: &dyn Fn(&mut hdf5_pure::GroupBuilder)| {
        with_gas(fill, count).write(&path).unwrap();
        refused(&path)
    };
    let places = |gas: &mut hdf5_pure::GroupBuilder| {
        gas.create_dataset("Coordinates").with_f64_data(&[0.0; 6]).with_shape(&[2, 3]);
    };
    let none = message(2, &|gas| {
        gas.create_dataset("Masses").with_f64_data(&[1.0, 2.0]);
    });
    assert!(none.contains("there is no dataset PartType0/Coordinates; its datasets are Masses"), "{none}");
    let flat = message(2, &|gas| {
        gas.create_dataset("Coordinates").with_f64_data(&[1.0, 2.0]);
    });
    assert!(flat.contains("PartType0/Coordinates has 1 numbers a particle; it must have 3"), "{flat}");
    let short = message(2, &|gas| {
        places(gas);
        gas.create_dataset("Masses").with_f64_data(&[1.0]);
    });
    assert!(short.contains("PartType0/Masses has 1 rows where Coordinates has 2"), "{short}");
    let deep = message(2, &|gas| {
        places(gas);
        gas.create_dataset("Masses").with_f64_data(&[1.0; 8]).with_shape(&[2, 2, 2]);
    });
    assert!(deep.contains("PartType0/Masses has the shape [2, 2, 2]"), "{deep}");
    let nan = message(2, &|gas| {
        places(gas);
        gas.create_dataset("Density").with_f64_data(&[1.0, f64::NAN]);
    });
    assert!(nan.contains("PartType0/Density has NaN for particle 1; it must be a finite number"), "{nan}");
    let text = message(2, &|gas| {
        places(gas);
        gas.create_dataset("Density").with_ascii_strings(&["a", "b"]).unwrap();
    });
    assert!(text.contains("the dataset PartType0/Density cannot be read"), "{text}");
    let twice = message(2, &|gas| {
        places(gas);
        gas.create_dataset("ParticleIDs").with_u64_data(&[3, 3]);
    });
    assert!(twice.contains("two particles have the id 3"), "{twice}");
    let count = message(1_000_000_000_000_000_000, &places);
    assert!(count.contains("Header/NumPart_ThisFile says 1000000000000000000 particles where"), "{count}");
    let mut other = FileBuilder::new();
    other.create_dataset("x").with_f64_data(&[1.0]);
    other.write(&path).unwrap();
    assert!(refused(&path).contains("there is no group Header"), "{}", refused(&path));
}

/// A dataset that claims 10^15 rows, of which the file holds none: refused before anything is allocated.
#[test]
fn an_absurd_size_is_refused() {
    let place = Place::new("absurd");
    let path = place.path("a.hdf5");
    let fill = |gas: &mut hdf5_pure::GroupBuilder| {
        gas.create_dataset("Coordinates").with_f64_data(&[0.0; 6]).with_shape(&[2, 3]);
    };
    with_gas(fill, 2).write(&path).unwrap();
    let mut bytes = std::fs::read(&path).unwrap();
    // The dataspace's two extents, one after the other; its header's checksum is not mended, so that either check may refuse it.
    let extents: Vec<u8> = [2_u64, 3].iter().flat_map(|n| n.to_le_bytes()).collect();
    let at = bytes.windows(16).position(|window| window == extents).unwrap();
    bytes[at..at + 8].copy_from_slice(&1_000_000_000_000_000_u64.to_le_bytes());
    std::fs::write(&path, &bytes).unwrap();
    let message = refused(&path);
    assert!(message.contains("claims 1000000000000000 rows") || message.contains("hecksum"), "{message}");
}
