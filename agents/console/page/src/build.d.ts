// What build.mjs puts into the bundle.

declare const PAGE_VERSION: string;
