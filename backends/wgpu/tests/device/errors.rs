//! What goes wrong is a typed error with one sentence that names the remedy; nothing panics.

use etalon_wgpu::{
    AdapterPreference, Coordinates, Device, DeviceOptions, Drift, Error, FieldStore, NeighbourSearch, Parameters,
    PassBuffers, PassPipeline, Reducer, Timer, Torus, adapters, wgsl,
};

use crate::common::device;

/// One line, a remedy after the colon.
fn sentence(error: &Error) -> String {
    let message = error.to_string();
    assert!(!message.contains('\n'), "{message}");
    assert!(message.contains(": "), "no remedy: {message}");
    message
}

fn cube(count: usize, device: &Device, reach: f32) -> (Coordinates, FieldStore) {
    let coordinates = Coordinates::new(device, Torus::new(&[1.0; 3]).unwrap(), count).unwrap();
    let fields = FieldStore::new(device, 1, count).unwrap();
    fields.upload(device, 0, &vec![reach; count]).unwrap();
    (coordinates, fields)
}

#[test]
fn an_unknown_adapter_lists_the_known_ones() {
    let known = adapters();
    let error = Device::open(AdapterPreference::Named("no such card".into())).unwrap_err();
    if known.is_empty() {
        assert_eq!(error, Error::NoAdapter);
    } else {
        let message = sentence(&error);
        assert!(matches!(error, Error::AdapterNotFound { .. }), "{message}");
        assert!(message.contains(&known[0].name) && message.contains("no such card"), "{message}");
    }
}

#[test]
fn adapters_are_found_by_a_part_of_their_name() {
    let Some(device) = device() else { return };
    let name = &device.adapter().name;
    let part: String = name.chars().take(5).collect::<String>().to_uppercase();
    let found = Device::open(AdapterPreference::Named(part)).unwrap();
    assert!(found.adapter().name.to_lowercase().contains(&name.to_lowercase()[..5]));
}

#[test]
fn stores_beyond_the_bindings_are_refused() {
    if device().is_none() {
        return;
    }
    let options = DeviceOptions { preference: AdapterPreference::from_environment(), largest_binding: Some(1 << 20) };
    let device = &Device::open_with(&options).unwrap();
    assert_eq!(device.largest_binding(), 1 << 20);
    let error = FieldStore::new(device, 3, 100_000).unwrap_err();
    assert!(matches!(error, Error::TooLarge { needed: 1_200_000, limit: 1_048_576, .. }), "{error:?}");
    assert!(sentence(&error).contains("--backend simd"));

    // 1000 particles in one place have 999 000 list entries, of which 262 144 fit.
    let (coordinates, fields) = cube(1000, device, 0.1);
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    let error = search.build(device, &mut Timer::off()).unwrap_err();
    assert_eq!(error, Error::ListTooLong { entries: Some(999_000), limit: 262_144 });
    sentence(&error);
    // The search is not spoilt by it.
    let mut spread: Vec<u32> = (0..1000).map(|k| k * 4_294_967).collect();
    coordinates.upload(device, 0, &spread).unwrap();
    spread.reverse();
    coordinates.upload(device, 1, &spread).unwrap();
    assert!(search.build(device, &mut Timer::off()).unwrap().entries < 262_144);
}

#[test]
fn bad_reaches_are_refused() {
    let Some(device) = device() else { return };
    let (coordinates, fields) = cube(100, device, 0.1);
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    for later in [false, true] {
        for bad in [0.0, -0.0, -1.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, -f32::NAN] {
            let mut reach = vec![0.1; 100];
            reach[42] = bad;
            fields.upload(device, 0, &reach).unwrap();
            let error = search.build(device, &mut Timer::off()).unwrap_err();
            assert!(matches!(error, Error::BadReach { .. }), "{bad}, later {later}: {error:?}");
            sentence(&error);
        }
        // The second time round the cells exist already, and the kernels meet the bad reach.
        fields.upload(device, 0, &[0.1; 100]).unwrap();
        assert_eq!(search.build(device, &mut Timer::off()).unwrap().entries, 9900);
    }
}

#[test]
fn data_of_the_wrong_shape_is_refused() {
    let Some(device) = device() else { return };
    let (coordinates, fields) = cube(10, device, 0.1);
    let torus = *coordinates.torus();
    let errors = [
        fields.upload(device, 0, &[0.0; 9]).unwrap_err(),
        fields.upload(device, 1, &[0.0; 10]).unwrap_err(),
        fields.download(device, 7).unwrap_err(),
        coordinates.upload(device, 0, &[0; 11]).unwrap_err(),
        coordinates.upload(device, 3, &[0; 10]).unwrap_err(),
        FieldStore::new(device, 1, 0).unwrap_err(),
        FieldStore::new(device, 1, 1 << 31).unwrap_err(),
        Coordinates::new(device, torus, usize::MAX).unwrap_err(),
        Parameters::new(device, 2).unwrap().upload(device, 1, &[0.0; 2]).unwrap_err(),
        Parameters::new(device, 2).unwrap().upload(device, usize::MAX, &[0.0; 2]).unwrap_err(),
        NeighbourSearch::new(device, &coordinates, &fields, 1).unwrap_err(),
        Drift::new(device, &coordinates, &fields, 0).unwrap_err(),
        Drift::new(device, &coordinates, &fields, usize::MAX).unwrap_err(),
        Reducer::new(device).unwrap().reduction(device, &fields, 1).unwrap_err(),
        NeighbourSearch::new(device, &Coordinates::new(device, torus, 11).unwrap(), &fields, 0).unwrap_err(),
    ];
    for error in &errors {
        assert!(
            matches!(
                error,
                Error::WrongLength { .. }
                    | Error::NoSuchIndex { .. }
                    | Error::BadCount { .. }
                    | Error::CountMismatch { .. }
            ),
            "{error:?}"
        );
        sentence(error);
    }
}

#[test]
fn refused_text_names_its_pass() {
    let Some(device) = device() else { return };
    let prelude = wgsl::pass_prelude(3);
    let header = "@compute @workgroup_size(WORKGROUP) fn run() ";
    for (text, entry, expected) in [
        ("let x = ;".to_owned(), "run", "expected"),
        (format!("{header} {{ let x: u32 = 1.0; }}"), "run", "u32"),
        (format!("{header} {{ }}"), "another", "another"),
        (
            format!("@group(0) @binding(9) var<storage> more: array<u32>; {header} {{ let x = more[0]; }}"),
            "run",
            "binding: 9",
        ),
    ] {
        match PassPipeline::new(device, "density", &(prelude.clone() + &text), entry) {
            Err(Error::Shader { kernel, message }) => {
                assert_eq!(kernel, "density");
                assert!(message.contains(expected), "{message}");
            }
            other => panic!("{text}: {other:?}"),
        }
    }
}

#[test]
fn a_lost_device_is_an_error_everywhere() {
    if device().is_none() {
        return;
    }
    let device = &Device::open(AdapterPreference::from_environment()).unwrap();
    let (coordinates, fields) = cube(100, device, 0.1);
    let mut search = NeighbourSearch::new(device, &coordinates, &fields, 0).unwrap();
    search.build(device, &mut Timer::off()).unwrap();
    let reduction = Reducer::new(device).unwrap().reduction(device, &fields, 0).unwrap();
    let parameters = Parameters::new(device, 1).unwrap();
    let text = wgsl::pass_prelude(3) + "@compute @workgroup_size(WORKGROUP) fn run() { }";
    let pipeline = PassPipeline::new(device, "nothing", &text, "run").unwrap();
    let buffers =
        PassBuffers { fields: &fields, coordinates: &coordinates, lists: search.lists(), parameters: &parameters };
    let bindings = pipeline.bind(device, &buffers).unwrap();
    device.close();
    let errors = [
        bindings.run(device, &mut Timer::off(), &[&pipeline]).unwrap_err(),
        pipeline.bind(device, &buffers).unwrap_err(),
        fields.upload(device, 0, &[0.2; 100]).unwrap_err(),
        fields.download(device, 0).unwrap_err(),
        FieldStore::new(device, 1, 10).unwrap_err(),
        reduction.run(device, &mut Timer::off()).unwrap_err(),
        reduction.read(device).unwrap_err(),
        search.build(device, &mut Timer::off()).unwrap_err(),
        Reducer::new(device).unwrap_err(),
        Timer::new(device).unwrap_err(),
    ];
    for error in &errors {
        assert!(matches!(error, Error::DeviceLost { .. }), "{error:?}");
        sentence(error);
    }
}
